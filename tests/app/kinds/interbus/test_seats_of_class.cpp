// SPDX-License-Identifier: GPL-3.0-or-later
// A class, each at a ring of its own: what the trainer sees of a seat, does to it, and hands out for it.
#include "app/window/kinds/interbus/offer_files.h"
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "project/project_file.h"
#include "tests/app/kinds/interbus/offer_test.h"
#include "tests/app/question.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QTabWidget>

#include <functional>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;
using test::ModbusClient;
using test::partOf;
using test::Question;

constexpr std::uint16_t inRun = 0x00E0;
enum SeatColumn : std::uint8_t { faultsColumn = 3, inColumn = 5, outColumn };

class SeatsOfClass : public test::OfferTest
{
protected:
    void offerSeats(int count)
    {
        offer(count);
        partOf<QTabWidget>(offerPage(), "offeredTables")
            .setCurrentWidget(&partOf<QWidget>(offerPage(), "seatPage"));
        EXPECT_TRUE(waitFor([&] { return seats().model()->rowCount() == count; }));
    }
    QTableView &seats() { return partOf<QTableView>(offerPage(), "seatTable"); }
    void choose(int seat)
    {
        QTest::mouseClick(seats().viewport(), Qt::LeftButton, {},
                          seats().visualRect(seats().model()->index(seat - 1, 0)).center());
        window().showFrame();
    }
    QWidget &panel() { return partOf<QWidget>(offerPage(), "seatPanel"); }
    QCheckBox &box(const char *text)
    {
        for (auto *box : panel().findChildren<QCheckBox *>())
            if (box->text() == QLatin1String(text))
                return *box;
        qFatal("no %s", text);
    }
    QString inSeat(int seat, SeatColumn column) { return inTable("seatTable", seat - 1, column); }
    // Answers the dialog, `then` prepares the answer to what is asked next.
    static Question saveInto(
        const QString &path, std::function<void()> then = [] {})
    {
        return Question([path, then = std::move(then)](QWidget &dialog) {
            auto &files = dynamic_cast<QFileDialog &>(dialog);
            files.selectFile(path);
            QMetaObject::invokeMethod(&files, "accept");
            then();
        });
    }
    QString inFolder(const char *file) const { return folder.filePath(QLatin1String(file)); }
};

TEST_F(SeatsOfClass, AFaultIsForTheChosenSeatOnly)
{
    offerSeats(3);
    EXPECT_FALSE(panel().isVisible());
    choose(2);
    ASSERT_TRUE(panel().isVisible());
    box("Wire break before it").click();
    ModbusClient first(port(), 1);
    ModbusClient second(port(), 2);
    EXPECT_TRUE(waitFor([&] { return second.readInput(8'192, 1) != std::vector{inRun}; }));
    EXPECT_EQ(first.readInput(8'192, 1), std::vector{inRun});
    EXPECT_TRUE(waitFor([&] {
        return inSeat(2, faultsColumn) == QStringLiteral("1.0: Wire break before it");
    })) << inSeat(2, faultsColumn).toStdString();
    EXPECT_EQ(inSeat(1, faultsColumn), QString());
    EXPECT_TRUE(isSaid(QStringLiteral("Seat 2: 1.0: Wire break before it")));
    choose(3);
    EXPECT_FALSE(box("Wire break before it").isChecked()) << "what is shown is the seat's own";
    EXPECT_EQ(partOf<QLabel>(panel(), "seatTreated").text(), QStringLiteral("Seat 3"));
    box("Power on").click();
    EXPECT_TRUE(isSaid(QStringLiteral("Seat 3, 1.0: Power off.")));
    EXPECT_TRUE(
        waitFor([&] { return inSeat(3, faultsColumn) == QStringLiteral("1.0: Encoder switched off"); }));
}

TEST_F(SeatsOfClass, ASeatThatStartsAfreshIsTreatedAnew)
{
    offerSeats(2);
    choose(1);
    box("Device without supply").click();
    EXPECT_TRUE(waitFor([&] {
        return inSeat(1, faultsColumn) == QStringLiteral("1.0: Device without supply");
    })) << inSeat(1, faultsColumn).toStdString();
    click("restartSeat");
    EXPECT_TRUE(waitFor([&] { return inSeat(1, faultsColumn).isEmpty(); }));
    EXPECT_FALSE(box("Device without supply").isChecked());
    box("Power on").click();
    EXPECT_TRUE(waitFor([&] { return !ring().offer().controls(1)->shafts().front().powered; }));
    EXPECT_TRUE(ring().offer().controls(2)->shafts().front().powered);
    click("stopOffering");
    EXPECT_FALSE(panel().isVisible());
    EXPECT_EQ(ring().offer().controls(1), nullptr);
}

TEST_F(SeatsOfClass, WordsOfTheChosenDeviceAreInTheTable)
{
    offerSeats(2);
    ModbusClient second(port(), 2);
    ASSERT_EQ(second.write(0, {0x0200, 0x00FF}), 0);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("020000FF"); }));
    EXPECT_TRUE(waitFor([&] { return inSeat(2, inColumn) == QStringLiteral("C20000FF"); }));
    EXPECT_EQ(inSeat(1, outColumn), QStringLiteral("00000000"));
    auto &device = partOf<QComboBox>(offerPage(), "seatDevice");
    EXPECT_TRUE(device.currentText().startsWith(QStringLiteral("1.0")));
    EXPECT_EQ(device.count(), 6) << "without the bus terminal";
    device.setCurrentIndex(1);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("00000000"); }));
    ASSERT_EQ(second.write(2, {0, 7}), 0);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("00000007"); }));
    choose(2);
    box("Wire break before it").click();
    EXPECT_TRUE(waitFor([&] { return inSeat(2, inColumn) == QStringLiteral("\u2013"); })) << "not of now";
}

TEST_F(SeatsOfClass, AFaultPlanInASeatIsTold)
{
    offerSeats(2);
    ring().offer().controls(2)->startFaultPlan(
        {{}, {{std::chrono::milliseconds(1), TrainingFault::peripheralFault, NodeId("1.0"), 1}}});
    EXPECT_TRUE(waitFor([&] { return isSaid(QStringLiteral("Seat 2: 1.0: Peripheral fault")); }));
}

TEST_F(SeatsOfClass, AFileConnectsToItsSeat)
{
    offerSeats(2);
    {
        const Question folders = saveInto(folder.path());
        click("clientFiles");
    }
    EXPECT_TRUE(problem().contains(QStringLiteral("2 files saved"))) << problem().toStdString();
    EXPECT_TRUE(problem().contains(QStringLiteral("on this computer only")));
    const auto project = loadProject(inFolder("seat-02.codewheel"));
    ASSERT_TRUE(project);
    EXPECT_EQ(project->buses.size(), 1U);
    EXPECT_EQ(project->buses.front().name, QStringLiteral("Ring, seat 2"));
    const auto gateway = plannedGateway(*project, firstBus);
    ASSERT_TRUE(gateway && *gateway);
    const Catalog catalog = Catalog::builtIn();
    RingSession student(std::make_unique<GatewayLink>(std::make_unique<ModbusPort>(**gateway), **gateway,
                                                      gatewayDevices(*project, firstBus, catalog)),
                        catalog, QDateTime::currentDateTime());
    ASSERT_TRUE(student.open(RingSession::Start::operating));
    student.advance(1);
    EXPECT_EQ(student.structure().size(), bus().structure().size());
    student.channel(fraba)->stage(0x0200'00FF);
    ASSERT_TRUE(student.channel(fraba)->write());
    student.advance(100);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("020000FF"); }));
    EXPECT_EQ(inSeat(1, outColumn), QStringLiteral("00000000"));
}

TEST_F(SeatsOfClass, WhatIsThereIsReplacedOnlyAfterAsking)
{
    const QByteArray precious = "precious";
    const auto write = [&](const char *name) {
        QFile file(inFolder(name));
        return file.open(QIODevice::WriteOnly) && file.write(precious) == precious.size();
    };
    const auto content = [&](const char *name) {
        QFile file(inFolder(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    ASSERT_TRUE(write("seat-02.codewheel"));
    offerSeats(2);
    const auto saveAnd = [&](const QString &answer) {
        std::optional<Question> replace;
        const Question folders =
            saveInto(folder.path(), [&] { replace.emplace(Question::answeredBy(answer)); });
        click("clientFiles");
        ASSERT_TRUE(replace && replace->wasAsked());
        EXPECT_TRUE(replace->text().contains(QStringLiteral("seat-02.codewheel")))
            << replace->text().toStdString();
        EXPECT_FALSE(replace->text().contains(QStringLiteral("seat-01.codewheel")));
    };
    saveAnd(QStringLiteral("Cancel"));
    EXPECT_EQ(content("seat-02.codewheel"), precious);
    EXPECT_FALSE(QFileInfo::exists(inFolder("seat-01.codewheel")));
    saveAnd(QStringLiteral("Replace"));
    EXPECT_TRUE(loadProject(inFolder("seat-02.codewheel")));
    EXPECT_EQ(content("seat-02.codewheel~"), precious);
}

TEST_F(SeatsOfClass, WhatCannotBeWrittenIsSaid)
{
    ASSERT_TRUE(QDir(folder.path()).mkpath(QStringLiteral("seat-02.codewheel")));
    offerSeats(3);
    std::optional<Question> replace;
    const Question folders =
        saveInto(folder.path(), [&] { replace.emplace(Question::answeredBy(QStringLiteral("Replace"))); });
    click("clientFiles");
    EXPECT_TRUE(problem().contains(QStringLiteral("before seat 2"))) << problem().toStdString();
    EXPECT_TRUE(problem().contains(QStringLiteral("seat-02.codewheel"))) << problem().toStdString();
    EXPECT_FALSE(QFileInfo::exists(inFolder("seat-03.codewheel")));
}

TEST_F(SeatsOfClass, OneRingForAllHasOneFile)
{
    offer();
    const Question files = saveInto(inFolder("class.codewheel"));
    click("clientFiles");
    const auto project = loadProject(inFolder("class.codewheel"));
    ASSERT_TRUE(project) << problem().toStdString();
    const auto gateway = plannedGateway(*project, firstBus);
    ASSERT_TRUE(gateway && *gateway);
    EXPECT_EQ((*gateway)->host, QStringLiteral("127.0.0.1"));
    EXPECT_EQ((*gateway)->tcpPort, port());
    EXPECT_EQ((*gateway)->unit, 1);
    EXPECT_TRUE((*gateway)->tellsRing()) << "so that a stopped ring is seen";
}

class FilesForOthers : public SeatsOfClass
{
protected:
    FilesForOthers()
    {
        const auto begun = ring().offer().begin({.address = QStringLiteral("0.0.0.0"), .port = 0});
        EXPECT_TRUE(begun);
    }
    std::optional<OfferFiles::Outcome> save(const QStringList &own)
    {
        return OfferFiles(ring().offer(), own, folder.path(), window()).save();
    }
    QString hostIn(const char *file)
    {
        const auto project = loadProject(inFolder(file));
        return project ? ringPlan(*project, firstBus).link.settings.at(QStringLiteral("host")) : QString();
    }
};

TEST_F(FilesForOthers, OfSeveralAddressesOneIsAskedFor)
{
    std::optional<Question> files;
    const Question addresses([&](QWidget &dialog) {
        auto *field = dialog.findChild<QComboBox *>();
        ASSERT_NE(field, nullptr);
        EXPECT_EQ(field->count(), 2) << "none of IP version 6, at which it is not offered";
        field->setCurrentIndex(1);
        dynamic_cast<QDialog &>(dialog).accept();
        files.emplace(saveInto(inFolder("one.codewheel")));
    });
    const auto saved =
        save({QStringLiteral("192.0.2.7"), QStringLiteral("2001:db8::7"), QStringLiteral("198.51.100.7")});
    ASSERT_TRUE(saved);
    EXPECT_TRUE(saved->sentence.contains(QStringLiteral("must reach"))) << saved->sentence.toStdString();
    EXPECT_EQ(hostIn("one.codewheel"), QStringLiteral("198.51.100.7"));
}

TEST_F(FilesForOthers, TheOnlyAddressIsNotAskedFor)
{
    const Question files = saveInto(inFolder("one.codewheel"));
    ASSERT_TRUE(save({QStringLiteral("192.0.2.7")}));
    EXPECT_EQ(hostIn("one.codewheel"), QStringLiteral("192.0.2.7"));
}

TEST_F(FilesForOthers, WithoutANetworkThereIsNothingToHandOut)
{
    const auto saved = save({});
    ASSERT_TRUE(saved);
    EXPECT_TRUE(saved->sentence.contains(QStringLiteral("no address"))) << saved->sentence.toStdString();
}

} // namespace
} // namespace codewheel
