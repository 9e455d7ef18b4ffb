// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// FRABA manual 5.3, with the position of the training bus before and after.
TEST(CliWords, SendsTheTableOfTheManualBitForBit)
{
    const CliRun run =
        runLine(QStringLiteral("words 1.0 020000FF 04000001 06000003 08000000 80000000 00000000 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(rowsOf(run.json()),
                ElementsAre("00000000 00003039", "020000FF 00003039", "020000FF C20000FF",
                            "04000001 C20000FF", "04000001 C4000001", "06000003 C4000001",
                            "06000003 C6000003", "08000000 C6000003", "08000000 C8000000",
                            "80000000 C8000000", "80000000 00000180", "00000000 00000180"));
}

TEST(CliWords, PrintsOutAndInSideBySideWithTheirMeaning)
{
    const CliRun run = runLine(QStringLiteral("words 1.0 020000FF 04000001 80000000 00000000"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("cycle  OUT       IN        OUT means "));
    EXPECT_THAT(run.out, HasSubstr("    5  020000FF  C20000FF  Parameter 1 steps = 255      Parameter 1 "
                                   "steps = 255 confirmed\n"));
    EXPECT_THAT(run.out, HasSubstr("    6  04000001  C20000FF  Parameter 2 revolutions = 1  Old "
                                   "confirmation: parameter 1 steps = 255\n"));
}

// FRABA manual 5.4.4. Until the encoder has taken the next read-out, IN holds the value of the one before.
TEST(CliWords, AnOldReadOutIsNotTakenForTheAnswerToTheNewWord)
{
    const CliRun run = runLine(
        QStringLiteral("words 1.0 20800001 46000015 66000213 20400008 80000000 20200013 20200023 20200000"));
    EXPECT_THAT(
        run.out,
        HasSubstr("20200013  A0000015  Read out the start of cam 3  Read-out: start of cam 3 = 21\n"));
    EXPECT_THAT(run.out,
                HasSubstr("20200023  A0000015  Read out the stop of cam 3   Self test, or read-out of 21\n"));
    EXPECT_THAT(
        run.out,
        HasSubstr("20200023  A0000213  Read out the stop of cam 3   Read-out: stop of cam 3 = 531\n"));
    EXPECT_THAT(
        run.out,
        HasSubstr("20200000  A0000213  Read out the active cams     Self test, or read-out of 531\n"));
    EXPECT_THAT(run.out,
                HasSubstr("20200000  A0000008  Read out the active cams     Read-out: active cams 3\n"));
}

TEST(CliWords, BaumerExample2EndsInError1)
{
    const CliRun run = runLine(QStringLiteral("words 2.0 04004E20 06000001 80000000 --json"));
    EXPECT_EQ(run.exit, 1);
    const std::vector<std::string> rows = rowsOf(run.json());
    EXPECT_THAT(std::vector(rows.begin() + 2, rows.end()),
                ElementsAre("04004E20 C0004E20", "04004E20 C4004E20", "06000001 C4004E20",
                            "06000001 C4000001", "06000001 C6000001", "80000000 C6000001",
                            "80000000 82000000"));
    EXPECT_EQ(errorKey(run), "wrongParameterData");
    EXPECT_THAT(run.err, HasSubstr("82000000"));
    EXPECT_EQ(run.json()[u"leftIn"], QStringLiteral("error"));
}

TEST(CliWords, AnErrorEndsTheSequence)
{
    const CliRun run = runLine(QStringLiteral("words 2.0 04004E20 80000000 020000FF --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(rowsOf(run.json()).back(), "80000000 82000000");
}

// Baumer manual: leave the error with a new value and run.
TEST(CliWords, AfterAnErrorTheWayOutCanBeTried)
{
    const CliRun out = runLine(
        QStringLiteral("words 2.0 04004E20 80000000 04000001 80000000 00000000 --after-error go-on --json"));
    EXPECT_EQ(out.exit, 0) << out.err;
    EXPECT_THAT(rowsOf(out.json()), testing::IsSupersetOf({"80000000 82000000", "04000001 C4000001"}));
    EXPECT_EQ(out.json()[u"leftIn"], QStringLiteral("operation"));

    const CliRun in =
        runLine(QStringLiteral("words 2.0 04004E20 80000000 00000000 --after-error go-on --json"));
    EXPECT_EQ(in.exit, 1) << "it is in error still";
    EXPECT_EQ(errorKey(in), "wrongParameterData");
    EXPECT_EQ(in.json()[u"leftIn"], QStringLiteral("error"));

    const CliRun last = runLine(QStringLiteral("words 1.0 2021000F --after-error go-on --json"));
    EXPECT_EQ(last.exit, 1);
    EXPECT_EQ(errorKey(last), "readOutUnknown");
    EXPECT_EQ(runLine(QStringLiteral("words 1.0 2021000F 00000000 --after-error go-on")).exit, 0);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("words 1.0 00000000 --after-error on --json"))),
              "optionNotAllowed");
}

TEST(CliWords, ServicesGoOnAfterAnErrorToo)
{
    SharedBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("words 5.0 C2000000 00000000")).exit, 1);
    EXPECT_EQ(bus.runLine(QStringLiteral("words 5.0 C2000000 00000000 --after-error go-on")).exit, 1);
    EXPECT_EQ(bus.runLine(QStringLiteral("words 5.0 C2000000 C200C350 00000000 --after-error go-on")).exit,
              0);
}

int cyclesOfPreset(SharedBus &bus, const QString &option = {})
{
    const QJsonObject json =
        bus.runLine(QStringLiteral("words 1.0 40000000 00000000 --json ") + option).json();
    int begun = -1;
    for (const QJsonValue row : json[u"trace"].toArray()) {
        if (begun < 0 && row[u"out"] == QStringLiteral("40000000"))
            begun = row[u"cycle"].toInt();
        if (begun >= 0 && row[u"out"] == QStringLiteral("00000000"))
            return row[u"cycle"].toInt() - begun;
    }
    return -1;
}

TEST(CliWords, ThePresetStandsUntilThePositionHasFollowed)
{
    SharedBus bus;
    ASSERT_EQ(bus.runLine(QStringLiteral("words 1.0 080003E8 80000000 00000000")).exit, 0);
    const CliRun run = bus.runLine(QStringLiteral("words 1.0 40000000 00000000 --json"));
    EXPECT_THAT(rowsOf(run.json()), ElementsAre("00000000 00003039", "40000000 00003039", "40000000 000003E8",
                                                "00000000 000003E8"));
    EXPECT_EQ(cyclesOfPreset(bus), 200) << "programmed once, it works once: nothing follows";
    EXPECT_EQ(cyclesOfPreset(bus, QStringLiteral("--hold 7")), 7);
    bus.controls().setSpeed(NodeId("1.0"), 60);
    ASSERT_EQ(bus.runLine(QStringLiteral("words 1.0 080003E8 80000000 00000000")).exit, 0);
    EXPECT_LT(cyclesOfPreset(bus), 10) << "it turns";
}

TEST(CliWords, AReadOutStandsUntilItIsAnswered)
{
    const CliRun run = runLine(QStringLiteral("words 1.0 20210001 00000000 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(rowsOf(run.json()), ElementsAre("00000000 00003039", "20210001 00003039", "20210001 A0002000",
                                                "00000000 A0002000", "00000000 00003039"));
}

TEST(CliWords, TheFrabaPresetStandsForOneCycleAndItsEffectIsShown)
{
    const CliRun run = runLine(QStringLiteral("words 1.0 60000000 --hold 10 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(rowsOf(run.json()),
                ElementsAre("00000000 00003039", "60000000 00003039", "00000000 00000000"));
    EXPECT_THAT(runLine(QStringLiteral("words 1.0 60000000")).out, HasSubstr("\nEEPROM writes:   1\n"));
}

int cyclesHeld(const QString &option)
{
    const QJsonObject json = runLine(QStringLiteral("words 1.0 01000000 00000000 --json ") + option).json();
    const QJsonArray trace = json[u"trace"].toArray();
    return trace[2][u"cycle"].toInt() - trace[1][u"cycle"].toInt();
}

TEST(CliWords, AWordThatNothingAcknowledgesStandsForThreeCyclesOrAsAsked)
{
    EXPECT_EQ(cyclesHeld({}), 3);
    EXPECT_EQ(cyclesHeld(QStringLiteral("--hold 20")), 20);
}

TEST(CliWords, TakesTheNotationsOfTheManuals)
{
    const std::vector<std::string> expected =
        rowsOf(runLine(QStringLiteral("words 1.0 020000FF 80000000 --json")).json());
    EXPECT_EQ(rowsOf(runLine(QStringLiteral("words 1.0 0x20000ff 80000000h --json")).json()), expected);
}

struct BadWords
{
    const char *line;
    const char *key;
    const char *help; // to be offered in the sentence
};

TEST(CliWords, AnEncoderWithoutOutTakesNone)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("words 3.0 020000FF"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("FRABA OCD-IB K1 has no OUT word: nothing can be sent to it."));
    EXPECT_EQ(shared.bus().channel("3.0"_ring)->out(), 0u);
}

class CliWordsBadInput : public testing::TestWithParam<BadWords>
{};

TEST_P(CliWordsBadInput, IsRefusedAndNothingIsSent)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QString::fromLatin1(GetParam().line) + QStringLiteral(" --json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), GetParam().key);
    EXPECT_THAT(run.err, HasSubstr(GetParam().help));
    EXPECT_EQ(shared.bus().latest().cycle, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Calls, CliWordsBadInput,
    testing::Values(BadWords{"words 1.0 020000FF 0200XYFF", "notAWord", "\"0200XYFF\" is not a word"},
                    BadWords{"words 1.0 0020000FF", "notAWord", "up to 8 hexadecimal digits"},
                    BadWords{"words 1.0 -1", "notAWord", "\"-1\""},
                    BadWords{"words 7.0 020000FF", "unknownDevice", "1.0, 2.0"},
                    BadWords{"words one 020000FF", "unknownDevice", "1.0, 2.0"},
                    BadWords{"words 1.0 020000FF --hold 0", "optionOutOfRange", "from 1 to"},
                    BadWords{"words 1.0 020000FF --hold x", "optionOutOfRange", "\"x\""}));

TEST(CliWords, AWrongCommandInCamModeIsToldAsOne)
{
    for (const char *word : {"020000FF", "50000001"}) {
        const CliRun run = runLine(QStringLiteral("words 1.0 20800001 %1").arg(QLatin1String(word)));
        EXPECT_EQ(run.exit, 1);
        EXPECT_NE(run.err.find("is a wrong command in cam mode"), std::string::npos) << run.err;
    }
}

} // namespace
} // namespace codewheel
