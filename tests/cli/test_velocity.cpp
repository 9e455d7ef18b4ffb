// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_controls.h"
#include "tests/cli/cli_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// FRABA manual 5.4.2 and 10.2
TEST(CliVelocity, SwitchesToRevolutionsPerMinuteAndBack)
{
    SharedBus shared;
    shared.controls().setSpeed(NodeId("1.0"), -150);
    const CliRun on = shared.runLine(QStringLiteral("velocity 1.0 on --trace --json"));
    EXPECT_EQ(on.exit, 0);
    EXPECT_THAT(rowsOf(on.json()),
                ElementsAre("00000000 00003039", StartsWith("20400001 "), "00000000 01FFFF6A"));
    EXPECT_EQ(on.json()[u"mode"], QStringLiteral("velocity"));
    EXPECT_EQ(on.json()[u"velocity"], -150);
    EXPECT_TRUE(on.json()[u"position"].isNull());
    shared.controls().setSpeed(NodeId("1.0"), 0);
    shared.controls().turnTo(NodeId("1.0"), 4711);
    EXPECT_EQ(shared.runLine(QStringLiteral("velocity 1.0 off")).out, "Position mode: 4711\n");
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST(CliVelocity, OffEndsCamMode)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 20800001 00000000"));
    const CliRun run = shared.runLine(QStringLiteral("velocity 1.0 off --json"));
    EXPECT_EQ(run.json()[u"mode"], QStringLiteral("position"));
    EXPECT_EQ(run.json()[u"position"], 12'345);
}

TEST(CliVelocity, WhereTheModeIsNotKnownTheUserSaysIt)
{
    SharedBus shared;
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating)); // after which nothing is known
    const CliRun run = shared.runLine(QStringLiteral("velocity 1.0 on"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("In cam mode the word 20400001 changes which cams are active"));
    EXPECT_EQ(shared.runLine(QStringLiteral("velocity 1.0 on --in-position-mode")).out,
              "Velocity mode: 0 rpm\n");
}

TEST(CliVelocity, AnEncoderInCamModeThatWasToldToBeInPositionModeIsNotSwitched)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 20800001 00000000"));
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating)); // after which nothing is known
    const CliRun run = shared.runLine(QStringLiteral("velocity 1.0 on --in-position-mode"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, testing::Not(HasSubstr("mode:")));
    EXPECT_THAT(run.err,
                HasSubstr("The encoder is in cam mode: there the word 20400001 changes which cams are "
                          "active (IN E0400001)."));
    EXPECT_THAT(run.err, HasSubstr("Run, or another mode, keeps it"));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("Switch it back"))) << "which keeps what was changed";
}

TEST(CliVelocity, AModeThatWasOnlyToldIsNoAnswer)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 020000FF"));
    shared.bus().close();
    ASSERT_TRUE(shared.bus().open(RingSession::Start::operating)); // after which nothing is known
    const CliRun run = shared.runLine(QStringLiteral("velocity 1.0 on --in-position-mode --json"));
    EXPECT_EQ(errorKey(run), "inParameterization");
    EXPECT_TRUE(run.json()[u"mode"].isNull()) << run.out;
}

TEST(CliVelocity, RefusesWhatMakesNoSense)
{
    EXPECT_EQ(errorKey(runLine(QStringLiteral("velocity 1.0 fast --json"))), "onOrOff");
    EXPECT_EQ(runLine(QStringLiteral("velocity 1.0 fast")).exit, 2);
}

TEST(CliVelocity, WhoHasNoVelocityModeIsToldSo)
{
    for (const char *place : {"2.0", "3.0", "4.0", "5.0"})
        for (const char *wanted : {"on", "off"}) {
            const CliRun run = runLine(
                QStringLiteral("velocity %1 %2 --json").arg(QLatin1String(place), QLatin1String(wanted)));
            EXPECT_EQ(errorKey(run), "velocityNotSupported") << place << ' ' << wanted;
            EXPECT_EQ(run.exit, 1);
            EXPECT_THAT(run.err, HasSubstr(" has no velocity mode."));
        }
}

} // namespace
} // namespace codewheel
