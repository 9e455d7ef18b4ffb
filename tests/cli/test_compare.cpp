// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QFile>
#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

QString example(const char *name)
{
    return QStringLiteral(CODEWHEEL_ROOT "/docs/examples/") + QString::fromLatin1(name);
}

TEST(CliCompare, IsExit0WhereAllIsTheSame)
{
    const CliRun run = runLine(QStringLiteral("compare ") + example("training.codewheel"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "same  1.0: K3 37h, as configured\n"
                       "same  2.0: K3 37h, as configured\n"
                       "same  3.0: K1 36h, as configured\n"
                       "same  4.0: K2 36h, as configured\n"
                       "same  5.0: LA-66 33h, as configured\n"
                       "same  6.0: bus terminal 0Ch, as configured\n"
                       "same  6.1: K3 B3h, as configured\n");
    EXPECT_EQ(run.err, "");
}

TEST(CliCompare, IsExit1WhereSomethingDiffers)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("compare ") + example("crane.codewheel"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("differs  3.0: configured K2 36h, found K1 36h\n"));
    EXPECT_THAT(run.out, HasSubstr("missing  5.0: configured 02h is missing\n"));
    EXPECT_THAT(run.err, HasSubstr("Lines that differ: 2."));
    EXPECT_EQ(shared.bus().latest().cycle, 0u) << "something was sent";
}

TEST(CliCompare, TellsProgramsTheSame)
{
    const CliRun run = runLine(QStringLiteral("compare --json ") + example("crane.codewheel"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "busDiffers");
    const QJsonArray lines = run.json()[u"lines"].toArray();
    ASSERT_EQ(lines.size(), 8);
    EXPECT_EQ(lines[2][u"comparison"], QStringLiteral("differs"));
    EXPECT_EQ(lines[2][u"configured"][u"deviceCode"], 0x236);
    EXPECT_EQ(lines[2][u"found"].toObject(),
              (QJsonObject{{QStringLiteral("place"), QStringLiteral("3.0")},
                           {QStringLiteral("idCode"), 0x36},
                           {QStringLiteral("deviceCode"), 0x136},
                           {QStringLiteral("inWords"), 1},
                           {QStringLiteral("outWords"), 0},
                           {QStringLiteral("level"), 0},
                           {QStringLiteral("device"), QStringLiteral("fraba-ocd-ib-k1")}}));
    EXPECT_EQ(lines[4][u"comparison"], QStringLiteral("missing"));
    EXPECT_TRUE(lines[4][u"found"].isNull());
}

TEST(CliCompare, OfWhatIsNoProjectIsBadInput)
{
    for (const QString &file : {QStringLiteral("missing.codewheel"), QStringLiteral(CODEWHEEL_ROOT),
                                QStringLiteral(CODEWHEEL_ROOT "/README.md")}) {
        const CliRun run = runLine(QStringLiteral("compare ") + file);
        EXPECT_EQ(run.exit, 2);
        EXPECT_THAT(run.err, HasSubstr(file.toStdString()));
    }
}

} // namespace
} // namespace codewheel
