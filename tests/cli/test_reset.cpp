// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(CliReset, TellsWhatIsLostAndReadsBack)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 1.0 steps=255 direction=ccw preset=7 --yes"));
    const CliRun run = shared.runLine(QStringLiteral("reset 1.0 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "1.0, FRABA OCD-IB K3, will be reset to factory settings (0E000000, then run).\n"
                       "This is lost: steps, revolutions, direction, preset, zero-offset.\n"
                       "All cam programs are lost, too, and the encoder is in position mode afterwards.\n"
                       "EEPROM writes:   1\n"
                       "\n"
                       "Read back:\n"
                       "steps        = 8192\n"
                       "revolutions  = 1\n"
                       "direction    = cw (3)\n"
                       "preset       = 0 steps\n"
                       "zero-offset  = 0 steps\n"
                       "EEPROM writes:   1\n"
                       "Position after:  12345\n");
    EXPECT_EQ(shared.eepromWrites(), 4);
}

TEST(CliReset, ABaumerHasTheFactorySettingsOfItsManual)
{
    const CliRun run = runLine(QStringLiteral("reset 2.0 --yes --trace --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(rowsOf(run.json()), testing::Contains(HasSubstr("0E000000 CE000000")));
    EXPECT_EQ(run.json()[u"values"].toArray().size(), 7);
    EXPECT_EQ(run.json()[u"eepromWrites"], 1);
    EXPECT_THAT(runLine(QStringLiteral("reset 2.0 --yes")).out,
                AllOf(HasSubstr("Factory settings, confirmed by the handshake:\n"),
                      HasSubstr("coding           = unsigned-cw (3)\n")));
}

TEST(CliReset, AsksFirst)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 1.0 steps=255 --yes"));
    const CliRun declined = shared.runLine(QStringLiteral("reset 1.0"), {.isThere = true, .types = "no\n"});
    EXPECT_THAT(declined.out, HasSubstr("Reset 1.0?"));
    EXPECT_THAT(declined.err, HasSubstr("Nothing was sent."));
    EXPECT_EQ(shared.eepromWrites(), 1);
    const CliRun agreed = shared.runLine(QStringLiteral("reset 1.0"), {.isThere = true, .types = "yes\n"});
    EXPECT_EQ(agreed.exit, 0);
    EXPECT_EQ(shared.eepromWrites(), 2);
}

TEST(CliReset, OfAnEncoderInParameterizationIsNotSentAndDoesNotWait)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("words 1.0 020000FF 00000000"));
    const CliRun run = shared.runLine(QStringLiteral("reset 1.0 --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("Nothing was written: the encoder is in parameterization already"));
    EXPECT_THAT(run.err, testing::Not(HasSubstr("waits for run")));
}

TEST(CliReset, WithoutAnybodyToAskNothingIsSent)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("reset 1.0 --json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "noConsent");
    EXPECT_EQ(shared.eepromWrites(), 0);
}

} // namespace
} // namespace codewheel
