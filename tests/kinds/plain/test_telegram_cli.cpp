// SPDX-License-Identifier: GPL-3.0-or-later
// The command line and encoders that are given all their values at once and keep none.
#include "cli/kinds/link_kind.h"
#include "project/project_file.h"
#include "tests/kinds/plain/plain_calls.h"
#include "tests/kinds/plain/plain_link_kind.h"

#include <QFile>
#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::telegramCrab;
using test::telegramWinch;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class TelegramCli : public test::PlainCalls
{
protected:
    TelegramCli()
        : PlainCalls(test::telegramStations())
    {}
};

TEST_F(TelegramCli, AWriteShowsWhatGoesAlongAndCostsNothing)
{
    const CliRun written = run(QStringLiteral("write n:4 2000:1=-5 --yes"));
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_THAT(written.out,
                AllOf(HasSubstr("all steps=4096 direction=0 2000:1=-5 1008="), HasSubstr("go along"),
                      HasSubstr("confirmed by the handshake"), HasSubstr("EEPROM writes:   0"),
                      Not(HasSubstr("scaling factor")), Not(HasSubstr("read back"))));
    const QJsonArray plan =
        run(QStringLiteral("write n:4 2000:1=6 --dry-run --json")).json()[u"plan"].toArray();
    ASSERT_EQ(plan.size(), 4);
    EXPECT_EQ(plan[0][u"goesAlong"], true);
    EXPECT_FALSE(plan[2].toObject().contains(u"goesAlong"));
}

TEST_F(TelegramCli, ReadingIsRefusedWithWhatIsKnown)
{
    const CliRun nothing = run(QStringLiteral("read n:4"));
    EXPECT_EQ(nothing.exit, 1);
    EXPECT_THAT(nothing.err, HasSubstr("nothing is known of it"));
    EXPECT_EQ(run(QStringLiteral("write n:4 2000:1=-5 --yes")).exit, 0);
    const CliRun known = run(QStringLiteral("read n:4"));
    EXPECT_EQ(known.exit, 1);
    EXPECT_THAT(known.out, AllOf(HasSubstr("Last written from here:"), HasSubstr("2000:1"),
                                 HasSubstr("confirmed, not stored")));
    EXPECT_EQ(run(QStringLiteral("read n:4 --json")).json()[u"known"][0][u"kept"],
              QStringLiteral("untilPowerOff"));
    bus.switchOffAndOn(telegramWinch);
    bus.advance(5ms);
    EXPECT_THAT(run(QStringLiteral("read n:4")).out, Not(HasSubstr("2000:1")));
}

TEST_F(TelegramCli, MonitorShowsAPositionOnlyOnceItHasItsValues)
{
    const auto states = [&] {
        const QJsonObject json = run(QStringLiteral("monitor n:4 --for 1 --every 1000 --json")).json();
        return json[u"samples"].toArray().last().toObject();
    };
    EXPECT_EQ(states()[u"state"], QStringLiteral("waiting"));
    EXPECT_TRUE(states()[u"position"].isNull());
    EXPECT_EQ(run(QStringLiteral("write n:4 steps=100 --yes")).exit, 0);
    EXPECT_EQ(states()[u"state"], QStringLiteral("operation"));
    EXPECT_FALSE(states()[u"position"].isNull());
}

TEST_F(TelegramCli, TransfersWhatAProjectWants)
{
    want(telegramCrab, {{test::plainFilter(), -5}, {Parameter::direction, 1}});
    const CliRun transferred = run(QStringLiteral("transfer ") + file + QStringLiteral(" --yes"));
    EXPECT_EQ(transferred.exit, 0) << transferred.err;
    EXPECT_THAT(transferred.out, AllOf(HasSubstr("Written: 2. Already there: 0. EEPROM writes: 0."),
                                       HasSubstr("go along"), Not(HasSubstr("read back"))));
    EXPECT_THAT(bus.telegram(telegramCrab).heard(), Contains("all steps=4096 direction=1 2000:1=-5 1008="));
    EXPECT_TRUE(bus.telegram(telegramWinch).heard().empty());
    bus.switchOffAndOn(telegramCrab);
    bus.advance(5ms);
    EXPECT_EQ(run(QStringLiteral("transfer ") + file + QStringLiteral(" --yes")).exit, 0);
    EXPECT_EQ(bus.telegram(telegramCrab).heard().size(), 2u) << "it is given them again";
}

TEST_F(TelegramCli, GivesAnotherEncoderTheSameValues)
{
    EXPECT_EQ(run(QStringLiteral("write n:4 2000:1=-5 1008=Winch --yes")).exit, 0);
    const CliRun cloned = run(QStringLiteral("clone n:4 n:5 --yes"));
    EXPECT_EQ(cloned.exit, 0) << cloned.err;
    EXPECT_EQ(bus.telegram(telegramCrab).inForce("2000:1"), "-5");
    EXPECT_EQ(bus.telegram(telegramCrab).inForce("1008"), "Winch");
}

TEST_F(TelegramCli, ReplacesAnEncoder)
{
    want(telegramWinch, {{test::plainFilter(), 12}});
    const CliRun replaced = run(QStringLiteral("replace n:4 --serial 9001 --yes --project ") + file);
    EXPECT_EQ(replaced.exit, 0) << replaced.err;
    EXPECT_EQ(bus.telegram(telegramWinch).inForce("2000:1"), "12");
    EXPECT_THAT(replaced.out, Not(HasSubstr("EEPROM writes: 1")));
}

TEST_F(TelegramCli, NothingIsCounted)
{
    const QString ledger = folder.filePath(QStringLiteral("ledger.sqlite"));
    EXPECT_EQ(test::callOn(bus, QStringLiteral("write n:4 steps=100 2000:1=-5 --yes"), ledger).exit, 0);
    const auto listed = test::callOn(bus, QStringLiteral("ledger entries --json"), ledger).json();
    EXPECT_TRUE(listed[u"entries"].toArray().isEmpty());
}

TEST_F(TelegramCli, DevicesSpeaksOfNoWritesOfItsEeprom)
{
    EXPECT_THAT(run(QStringLiteral("devices telegram-node")).out,
                HasSubstr("EEPROM writes: none, it keeps no value without supply"));
    EXPECT_THAT(run(QStringLiteral("devices plain-node")).out, HasSubstr("EEPROM writes: about 1"));
}

TEST_F(TelegramCli, WhatItCannotDoIsRefused)
{
    for (const char *line : {"reset n:4 --yes", "cams n:4 read", "preset n:4 500 --yes", "words n:4 0"}) {
        const CliRun refused = run(QLatin1String(line));
        EXPECT_EQ(refused.exit, 1) << line;
        EXPECT_THAT(refused.err, HasSubstr("Plain T1")) << line;
    }
    EXPECT_TRUE(bus.telegram(telegramWinch).heard().empty());
}

TEST_F(TelegramCli, IsRecordedAndExported)
{
    EXPECT_EQ(run(QStringLiteral("write n:4 steps=100 --yes")).exit, 0);
    const QString recording = folder.filePath(QStringLiteral("telegram.cwrec"));
    EXPECT_EQ(run(QStringLiteral("record n:4 --for 2 -o ") + recording).exit, 0);
    const QString csv = folder.filePath(QStringLiteral("telegram.csv"));
    EXPECT_EQ(run(QStringLiteral("export %1 -o %2").arg(recording, csv)).exit, 0);
    QFile exported(csv);
    ASSERT_TRUE(exported.open(QIODevice::ReadOnly));
    EXPECT_THAT(exported.readAll().toStdString(), HasSubstr("n:4"));
}

TEST_F(TelegramCli, ExplainsItsLines)
{
    const auto kind = addLinkKind(std::make_unique<test::PlainLinkKind>());
    const CliRun told = runWith({}, [](const Terminal &terminal) {
        return runCommandLine({QStringLiteral("explain"), QStringLiteral("all steps=100 2000:1=-5"),
                               QStringLiteral("--device"), QStringLiteral("telegram-node")},
                              terminal);
    });
    EXPECT_EQ(told.exit, 0) << told.err;
    EXPECT_EQ(told.out, "all steps=100 2000:1=-5, Plain T1\n  Steps := 100, Filter := -5\n");
}

} // namespace
} // namespace codewheel
