// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(CliScan, NamesEachParticipant)
{
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("scan"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "place  ID code    device code  IN words  OUT words  profile  device\n"
                       "1.0    37h (55)   0237h               2          2  K3       FRABA OCD-IB K3\n"
                       "2.0    37h (55)   0237h               2          2  K3       Baumer GXP6W K3\n"
                       "3.0    36h (54)   0136h               1          0  K1       FRABA OCD-IB K1\n"
                       "4.0    36h (54)   0236h               2          0  K2       FRABA OCD-IB K2\n"
                       "5.0    33h (51)   0233h               2          2  LA-66    TR LA-66\n"
                       "6.0    0Ch (12)   000Ch               0          0  -        bus terminal\n"
                       "6.1    B3h (179)  02B3h               2          2  K3       FRABA OCD-IB K3 Loop 2\n"
                       "\n"
                       "Master:         RUN\n"
                       "Status:         00E0h (READY, ACTIVE, RUN)\n"
                       "Fault:          none\n"
                       "Configuration:  training.json\n");
    EXPECT_EQ(shared.bus().latest().cycle, 0u);
}

TEST(CliScan, WhatIsForALineIsRefusedOnARingAlone)
{
    for (const char *option : {"--all-rates", "--master", "--first 05", "--last 05"}) {
        const CliRun run =
            runLine(QStringLiteral("scan --json --link interbus:training ") + QLatin1String(option));
        EXPECT_EQ(run.exit, 2) << option;
        EXPECT_EQ(run.json()[u"error"][u"key"], QStringLiteral("optionOfOtherBus")) << option;
        EXPECT_THAT(run.err, testing::HasSubstr("Serial line")) << option;
    }
}

TEST(CliScan, TellsProgramsTheSame)
{
    const QJsonArray participants = runLine(QStringLiteral("scan --json")).json()[u"participants"].toArray();
    ASSERT_EQ(participants.size(), 7);
    EXPECT_EQ(participants[1].toObject(),
              (QJsonObject{{QStringLiteral("place"), QStringLiteral("2.0")},
                           {QStringLiteral("idCode"), 0x37},
                           {QStringLiteral("deviceCode"), 0x237},
                           {QStringLiteral("inWords"), 2},
                           {QStringLiteral("outWords"), 2},
                           {QStringLiteral("level"), 0},
                           {QStringLiteral("profile"), QStringLiteral("K3")},
                           {QStringLiteral("device"), QStringLiteral("baumer-gxp6w")}}));
    EXPECT_EQ(participants[5].toObject(), (QJsonObject{{QStringLiteral("place"), QStringLiteral("6.0")},
                                                       {QStringLiteral("idCode"), 0x0C},
                                                       {QStringLiteral("deviceCode"), 0x0C},
                                                       {QStringLiteral("inWords"), 0},
                                                       {QStringLiteral("outWords"), 0},
                                                       {QStringLiteral("level"), 0},
                                                       {QStringLiteral("profile"), QJsonValue()},
                                                       {QStringLiteral("device"), QJsonValue()}}));
}

} // namespace
} // namespace codewheel
