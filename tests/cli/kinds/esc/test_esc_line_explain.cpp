// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/esc/shared_line.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

QString explainLine(const char *what)
{
    return QStringLiteral("explain %1 --device kuebler-esc-rs485").arg(QString::fromLatin1(what));
}

TEST(CliLineExplain, TellsWhatARequestMeans)
{
    const CliRun run = runLine(explainLine("03gp5200"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out,
              "03GP00005200 (1B 30 33 47 50 30 30 30 30 35 32 30 30 0D 0A), Kübler 5882 / 5862 / 9081 "
              "RS-485\n  03: set preset to 5200h = 20992\n");
    const QJsonObject json = runLine(explainLine("05P --direction out --json")).json();
    EXPECT_EQ(json[u"letters"], QStringLiteral("P"));
    EXPECT_EQ(json[u"bytes"], QStringLiteral("1B 30 35 50 0D 0A"));
    EXPECT_EQ(json[u"direction"], QStringLiteral("out"));
}

// The examples of the manual.
TEST(CliLineExplain, TellsWhatAnAnswerMeans)
{
    EXPECT_THAT(runLine(explainLine("00001235 --other 05P")).out, HasSubstr("05: position? -> 1235h = 4661"));
    EXPECT_THAT(runLine(explainLine("5000 --other 05A --direction in")).out,
                HasSubstr("5000h: battery flat, general fault"));
    EXPECT_THAT(runLine(explainLine("CRLF --other 05GD1")).out, HasSubstr("accepted"));
    EXPECT_THAT(runLine(explainLine("05 --other 05GD1")).out, HasSubstr("out of range (05)"));
    EXPECT_THAT(runLine(explainLine("03 --other 05P")).out, HasSubstr("command unknown (03)"));
    const QJsonObject json = runLine(explainLine("7005 --other 05O --json")).json();
    EXPECT_EQ(json[u"value"], 0x7005);
    EXPECT_EQ(json[u"bits"].toArray().size(), 5);
}

// Values that no encoder accepts or reports are still explained, and said to be out of range.
TEST(CliLineExplain, SaysWhatIsOutOfRange)
{
    const CliRun preset = runLine(explainLine("03GP0"));
    EXPECT_EQ(preset.exit, 0);
    EXPECT_THAT(preset.out, HasSubstr("03: set preset to 0h = 0, outside 1 to 33554431"));
    EXPECT_THAT(runLine(explainLine("CRLF --other 02X21")).out, HasSubstr("outside 1 to 31 -> accepted"));
    EXPECT_EQ(runLine(explainLine("03GP0 --json")).json()[u"outOfRange"], true);
    EXPECT_EQ(runLine(explainLine("03GP1 --json")).json()[u"outOfRange"], false);
    EXPECT_FALSE(runLine(explainLine("05P --json")).json().contains(u"outOfRange"));
    EXPECT_EQ(runLine(explainLine("7FFF --other 05B --json")).json()[u"outOfRange"], true);
    EXPECT_EQ(runLine(explainLine("00001235 --other 05P --json")).json()[u"outOfRange"], false);
    const QString factor = explainLine("40000000 --other 05F --json --link esc:training,fraction-bits=%1");
    EXPECT_EQ(runLine(factor.arg(30)).json()[u"outOfRange"], false);
    EXPECT_EQ(runLine(factor.arg(29)).json()[u"outOfRange"], true);
}

TEST(CliLineExplain, SwappedWarningsAreALinksSetting)
{
    EXPECT_THAT(runLine(explainLine("0098 --other 05E --link esc:training,swap-warnings=1")).out,
                HasSubstr("standstill"));
    EXPECT_THAT(runLine(QStringLiteral("read 05 warnings --link esc:training,swap-warnings=1")).out,
                HasSubstr("8000h, bytes swapped 0080h"));
}

TEST(CliLineExplain, RefusesWhatIsNoneOfThem)
{
    EXPECT_EQ(errorKey(runLine(explainLine("P05 --json"))), "notARequest");
    EXPECT_EQ(errorKey(runLine(explainLine("05P --direction in --json"))), "requestMissing");
    EXPECT_EQ(errorKey(runLine(explainLine("05P --direction out --other 05P --json"))), "requestTooMuch");
    EXPECT_EQ(errorKey(runLine(explainLine("1235 --other 05P --json"))), "notAnAnswer");
    EXPECT_EQ(errorKey(runLine(explainLine("CRLF --other 05P --json"))), "notAnAnswer");
    EXPECT_EQ(errorKey(runLine(explainLine("05P --mode cam --json"))), "optionOfWords");
}

TEST(CliDevices, ASerialEncoderHasItsCommands)
{
    const CliRun run = runLine(QStringLiteral("devices kuebler-esc-rs485"));
    EXPECT_THAT(run.out, HasSubstr("steps                         GR        D"));
    EXPECT_THAT(run.out, HasSubstr("preset                         -        S"));
    EXPECT_THAT(run.out, HasSubstr("000014F9h..20000000h")) << "the limits of write and explain";
    EXPECT_THAT(run.out, HasSubstr("8000h..A000h"));
    EXPECT_THAT(runLine(QStringLiteral("devices kuebler-esc-rs485 --link esc:training,fraction-bits=30")).out,
                HasSubstr("000029F1h..40000000h"));
}

} // namespace
} // namespace codewheel
