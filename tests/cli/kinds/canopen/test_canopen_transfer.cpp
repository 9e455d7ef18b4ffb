// SPDX-License-Identifier: GPL-3.0-or-later
// What a transfer may write of what only one maker has.
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "project/project_file.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

const Parameter speedOn = Parameter::of(u"3010:1");
const Parameter saveAndReset = Parameter::of(u"2300");

// Node 6, described as of a make that has 3010h:1, as the simulated one has, and 2300h, which it has not.
class CliCanTransfer : public testing::Test
{
protected:
    CliCanTransfer()
        : bus(encodersOfMake())
    {}

    void describe(const char *vendor)
    {
        QFile generic(QStringLiteral(CODEWHEEL_ROOT "/resources/devices/canopen-406-multi-turn.json"));
        ASSERT_TRUE(generic.open(QIODevice::ReadOnly));
        QByteArray json = generic.readAll();
        json.replace("\"key\": \"canopen-406-multi-turn\"",
                     "\"key\": \"rotor\", \"vendor\": \"Rotor Works\"");
        json.replace("\"physicalTurns\"", QByteArray("\"vendorNumber\": \"") + vendor +
                                              "\", \"productNumber\": \"25h\", \"physicalTurns\"");
        json.replace("\"parameters\": [",
                     R"("parameters": [{"parameter": "3010:1", "name": {"en": "Speed on"}, "object": "3010:1",
"type": "u8", "access": "rw", "minimum": 0, "maximum": 1},
{"parameter": "2300", "name": {"en": "Save and reset"}, "object": "2300", "type": "u32", "access": "wo",
"minimum": 0, "maximum": 1},)");
        ASSERT_TRUE(bus.catalog().add(json, QStringLiteral("rotor.json")));
    }
    void want(const ParameterValues &values)
    {
        Project project;
        setCanopenPlan(project, firstCanBus, {});
        std::vector<ProjectDevice> devices(1);
        devices[0].standAt({firstCanBus, NodeId("can:6")});
        devices[0].participant.deviceKey = QStringLiteral("rotor");
        devices[0].wanted = values;
        setDevicesOn(project, firstCanBus, std::move(devices));
        ASSERT_TRUE(saveProject(project, file));
    }
    CliRun transfer() { return bus.runLine(QStringLiteral("transfer %1 can:6 --yes --json").arg(file)); }
    int speedIsOn()
    {
        return bus.runLine(QStringLiteral("od can:6 read 3010:1 --json")).json()[u"value"].toInt(-1);
    }

    SharedCanBus bus;
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("p.codewheel"));

private:
    static std::vector<canopen::CanopenEncoderPlan> encodersOfMake()
    {
        auto encoders = canopen::trainingEncoders();
        encoders[1].quirks.speedIsOff = true;
        return encoders;
    }
};

TEST_F(CliCanTransfer, WritesAnObjectOfTheMakerWhereVendorAndDescriptionAgree)
{
    describe("10Dh");
    want({{speedOn, 1}});
    const CliRun run = transfer();
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(speedIsOn(), 1);
}

TEST_F(CliCanTransfer, WritesNoneWhereTheNodeIsOfAnotherVendor)
{
    describe("82h");
    want({{speedOn, 1}});
    const CliRun run = transfer();
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("deviceDiffers"));
    const CliRun named = bus.runLine(QStringLiteral("write can:6 3010:1=1 --device rotor --yes --json"));
    EXPECT_EQ(errorKey(named), "makeDiffers") << named.err;
    EXPECT_EQ(speedIsOn(), 0);
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
}

// What such an object does is a command to the device.
TEST_F(CliCanTransfer, NeverWritesWhatCanOnlyBeWritten)
{
    describe("10Dh");
    want({{speedOn, 1}, {saveAndReset, 1}});
    const CliRun run = transfer();
    EXPECT_EQ(run.exit, 0) << run.err << run.out;
    EXPECT_EQ(speedIsOn(), 1);
    const CliRun replaced =
        bus.runLine(QStringLiteral("replace can:6 --project %1 --yes --json --serial 1234340").arg(file));
    EXPECT_EQ(replaced.exit, 0) << replaced.err << replaced.out;
}

} // namespace
} // namespace codewheel
