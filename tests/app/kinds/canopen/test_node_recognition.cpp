// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/node_recognition.h"
#include "kinds/canopen/eds/device_description_json.h"
#include "kinds/canopen/eds/device_file_reader.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "widgets/project/device_names.h"
#include "widgets/project/project_document.h"

#include <QFile>
#include <QJsonDocument>
#include <QSignalSpy>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// Of node 6 of the training plant.
const QByteArray ownFile = "[DeviceInfo]\nVendorName=Rotor Works\nVendorNumber=0x10D\n"
                           "ProductName=Rotor 25\nProductNumber=0x25\nRevisionNumber=0x10000\n"
                           "[1000]\nDataType=7\nAccessType=ro\nDefaultValue=0x00020196\n"
                           "[2101]\nParameterName=Filter depth\nDataType=5\nAccessType=rw\n"
                           "[6001]\nDataType=7\nAccessType=rw\nLowLimit=1\nHighLimit=8192\n";

QByteArray descriptionJson(const QByteArray &bytes)
{
    QFile resource(QStringLiteral(":/devices/canopen-406-multi-turn.json"));
    EXPECT_TRUE(resource.open(QIODevice::ReadOnly));
    const auto file = canopen::readDeviceFile(bytes);
    EXPECT_TRUE(file);
    return QJsonDocument(canopen::descriptionOf(*file, QJsonDocument::fromJson(resource.readAll()).object(),
                                                QStringLiteral("rotor-25"), QStringLiteral("rotor.eds")))
        .toJson();
}

class NodeRecognitionTest : public test::CanopenPlant
{
protected:
    void connectDescribed(const QByteArray &file = ownFile)
    {
        ASSERT_TRUE(described.add(descriptionJson(file), QStringLiteral("rotor-25.json")));
        auto made = std::make_unique<test::WatchedCanLink>(plant->bus());
        link = made.get();
        bus = std::make_unique<CanopenSession>(std::move(made), described,
                                               QDateTime(QDate(2026, 11, 30), QTime(12, 0)));
        recognition.setBus(bus.get());
    }
    void pass(Instant time)
    {
        for (Instant passed{}; passed < time; passed += 50ms) {
            bus->advance(50ms);
            recognition.goOn();
        }
    }
    std::string deviceAt(Place place) const { return bus->encoder(place)->device().key.toStdString(); }

    Catalog described = Catalog::builtIn();
    ProjectDocument document;
    NodeRecognition recognition{document};
};

TEST_F(NodeRecognitionTest, ANodeWhoseIdentityFitsADescriptionIsDescribedByIt)
{
    connectDescribed();
    QSignalSpy told(&recognition, &NodeRecognition::recognised);
    operate();
    pass(2s);
    EXPECT_EQ(deviceAt(six), "rotor-25");
    EXPECT_EQ(deviceAt(five), "canopen-406-single-turn") << "another product";
    ASSERT_EQ(told.size(), 1);
    EXPECT_EQ(told.front().at(1).toString(), QStringLiteral("Rotor Works Rotor 25"));
}

TEST_F(NodeRecognitionTest, AnEncoderOfTheProjectIsDescribedSoThereToo)
{
    connectDescribed();
    Project project;
    setCanopenPlan(project, firstCanBus, {});
    ProjectDevice planned;
    planned.standAt(six);
    planned.participant.deviceKey = QStringLiteral("canopen-406-multi-turn");
    setDevicesOn(project, firstCanBus, {planned});
    document.setProject(project, {});
    const DeviceNames names(document, *bus);
    operate();
    pass(2s);
    EXPECT_EQ(document.device(six).participant.deviceKey, QStringLiteral("rotor-25"));
    document.undoStack().undo();
    pass(2s);
    EXPECT_EQ(deviceAt(six), "canopen-406-multi-turn") << "the user's word goes before it";
}

TEST_F(NodeRecognitionTest, AnotherRevisionOfTheProductIsAnotherDevice)
{
    QByteArray other = ownFile;
    other.replace("0x10000", "0x20000");
    connectDescribed(other);
    operate();
    pass(2s);
    EXPECT_EQ(deviceAt(six), "canopen-406-multi-turn");
}

TEST_F(NodeRecognitionTest, InWatchNobodyIsAskedAndWhatOthersHearCounts)
{
    connectDescribed();
    open(EncoderBus::Start::watching);
    pass(2s);
    EXPECT_EQ(sentTo(0x606), 0);
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
        say(test::canFrame(0x606, {0x40, 0x18, 0x10, sub, 0, 0, 0, 0}));
        pass(100ms);
    }
    EXPECT_EQ(deviceAt(six), "rotor-25");
}

TEST_F(NodeRecognitionTest, WithoutDescriptionsToRecogniseByNobodyIsAsked)
{
    recognition.setBus(bus.get());
    operate();
    pass(2s);
    EXPECT_TRUE(std::ranges::none_of(link->sent, [](const CanFrame &frame) {
        return frame.id == 0x606 && frame.bytes[1] == 0x18 && frame.bytes[2] == 0x10 && frame.bytes[3] < 4;
    }));
}

} // namespace
} // namespace codewheel
