// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CliRead, ReadsAllThatHasAReadOut)
{
    const CliRun run = runLine(QStringLiteral("read 1.0"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "steps                     = 8192\n"
                       "revolutions               = 1\n"
                       "direction                 = cw (3)\n"
                       "preset                    = 0 steps\n"
                       "zero-offset               = 0 steps\n"
                       "serial-number             = 20417 (4FC1h)\n"
                       "preset-flag               = activated (0)\n"
                       "software-version          = 259\n"
                       "operating-time            = 205.7 h\n"
                       "start-up-mode             = k3 (1)\n"
                       "multi-turn-steps-minus-1  = multi-turn (2)\n"
                       "temperature               = 24.5 °C\n");
}

TEST(CliRead, ReadsWhatIsNamedInThatOrder)
{
    const QJsonObject json = runLine(QStringLiteral("read 1.0 direction serial-number --json")).json();
    const QJsonArray values = json[u"values"].toArray();
    ASSERT_EQ(values.size(), 2);
    EXPECT_EQ(values[0].toObject(), (QJsonObject{{QStringLiteral("parameter"), QStringLiteral("direction")},
                                                 {QStringLiteral("value"), 3},
                                                 {QStringLiteral("choice"), QStringLiteral("cw")},
                                                 {QStringLiteral("unit"), QStringLiteral("none")}}));
    EXPECT_EQ(values[1][u"value"], 20417);
    EXPECT_EQ(json[u"device"], QStringLiteral("fraba-ocd-ib"));
}

// FRABA manual 10.2: 2021000C and 2021003D
TEST(CliRead, TemperatureHasItsUnitAndARegisterIsHexadecimal)
{
    EXPECT_EQ(runLine(QStringLiteral("read 1.0 temperature opc-register-0 opc-register-3")).out,
              "temperature     = 24.5 °C\n"
              "opc-register-0  = 0237h\n"
              "opc-register-3  = 0000h\n");
    const QJsonArray values =
        runLine(QStringLiteral("read 1.0 temperature opc-register-0 --json")).json()[u"values"].toArray();
    EXPECT_EQ(values[0][u"value"], 245);
    EXPECT_EQ(values[0][u"unit"], QStringLiteral("tenth-degree-celsius"));
    EXPECT_EQ(values[1][u"value"], 0x0237);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 2.0 opc-register-3 --json"))), "readingNotSupported");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 1.0 opc-register-16 --json"))), "unknownParameter");
}

TEST(CliRead, ATraceShowsTheReadOut)
{
    const CliRun run = runLine(QStringLiteral("read 1.0 serial-number --trace --json"));
    EXPECT_THAT(rowsOf(run.json()), ElementsAre("00000000 00003039", "20210000 00003039", "20210000 A0004FC1",
                                                "00000000 A0004FC1", "00000000 00003039"));
}

TEST(CliRead, TellsWhatWasWrittenBefore)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 1.0 steps=255 --yes"));
    EXPECT_EQ(shared.runLine(QStringLiteral("read 1.0 steps")).out, "steps  = 255\n");
}

TEST(CliRead, AnEncoderWithoutReadOutOfWhichNothingIsKnown)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("read 2.0"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("Baumer GXP6W K3 has no read-out"));
    EXPECT_THAT(run.err, HasSubstr("nothing is known of it"));
    EXPECT_LE(shared.bus().latest().cycle, 1u);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 2.0 --json"))), "readingNotSupported");
}

TEST(CliRead, AnEncoderWithoutReadOutTellsWhatWasWrittenFromHere)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 2.0 steps=4096 coding=gray-ccw --yes"));
    const CliRun run = shared.runLine(QStringLiteral("read 2.0"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.out, "Last written from here:\n"
                       "  steps   = 4096          confirmed\n"
                       "  coding  = gray-ccw (6)  confirmed\n");
    EXPECT_THAT(run.err, HasSubstr("has no read-out"));
    const QJsonObject json = shared.runLine(QStringLiteral("read 2.0 --json")).json();
    EXPECT_EQ(json[u"known"][0][u"value"], 4096);
    EXPECT_EQ(json[u"known"][0][u"evidence"], QStringLiteral("echoed"));
}

TEST(CliRead, AnEncoderThatOnlyTellsItsPositionHasNothingToRead)
{
    const CliRun run = runLine(QStringLiteral("read 3.0"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "codewheel-cli: The FRABA OCD-IB K1 has no read-out: its values cannot be read.\n");
}

// Device number of the branch behind the bus terminal 6.0
TEST(CliRead, ReadsAnEncoderOnTheLoop)
{
    const CliRun run = runLine(QStringLiteral("read 6.1 serial-number start-up-mode"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "serial-number  = 20418 (4FC2h)\n"
                       "start-up-mode  = k3 (1)\n");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("read 6.0 --json"))), "noEncoder");
}

struct BadRead
{
    const char *line;
    const char *key;
    const char *help;
};

class CliReadBadInput : public testing::TestWithParam<BadRead>
{};

TEST_P(CliReadBadInput, IsRefusedAndNothingIsSent)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QString::fromLatin1(GetParam().line) + QStringLiteral(" --json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), GetParam().key);
    EXPECT_THAT(run.err, HasSubstr(GetParam().help));
    EXPECT_LE(shared.bus().latest().cycle, 1u);
}

INSTANTIATE_TEST_SUITE_P(Calls, CliReadBadInput,
                         testing::Values(BadRead{"read 1.0 colour", "unknownParameter", "serial-number"},
                                         BadRead{"read 1.0 coding", "parameterNotSupported", "It has: steps"},
                                         BadRead{"read 1.0 steps steps", "parameterGivenTwice", "once"},
                                         BadRead{"read 1.1", "unknownDevice", "1.0, 2.0"}));

} // namespace
} // namespace codewheel
