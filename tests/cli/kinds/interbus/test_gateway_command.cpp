// SPDX-License-Identifier: GPL-3.0-or-later
// codewheel-cli gateway
#include "tests/cli/kinds/interbus/gateway_peer.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

QString wordsOf(const char *text)
{
    return QString::fromLatin1(text);
}

// "inArea passed"
std::vector<std::string> outcomesOf(const CliRun &run)
{
    std::vector<std::string> outcomes;
    for (const auto &step : run.json()[u"steps"].toArray())
        outcomes.push_back((step[u"step"].toString() + u' ' + step[u"outcome"].toString()).toStdString());
    return outcomes;
}

QJsonValue stepOf(const CliRun &run, int step)
{
    return run.json()[u"steps"].toArray()[step];
}

TEST(CliGateway, AGoodOnePassesAndNothingIsWritten)
{
    GatewayPeer peer(wordsOf("--devices 2"));
    const CliRun run = RingProject(2).run(wordsOf("gateway --json"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(outcomesOf(run), (std::vector<std::string>{"found passed", "connected passed",
                                                         "answered passed", "inArea passed", "outArea passed",
                                                         "word passed", "word passed", "map passed"}));
    const QJsonValue word = stepOf(run, 6);
    EXPECT_EQ(word[u"place"].toString(), wordsOf("2.0"));
    EXPECT_EQ(word[u"in"][u"first"].toInt(), 2);
    EXPECT_EQ(word[u"in"][u"registers"].toArray(), (QJsonArray{0, 2000}));
    EXPECT_EQ(word[u"readings"].toArray().size(), 4);
    EXPECT_EQ(word[u"readings"][1][u"word"].toString(), wordsOf("07D00000"));
    EXPECT_EQ(word[u"readings"][1][u"plausibility"].toString(), wordsOf("cannotBe"));
    EXPECT_TRUE(word[u"readings"][0][u"isSet"].toBool());
    EXPECT_EQ(peer.writes(), 0);
}

TEST(CliGateway, SaysThatItClosesTheConnectionAfterEachAnswer)
{
    GatewayPeer peer(wordsOf("--devices 2 --closes 3"));
    const CliRun run = RingProject(2).run(wordsOf("gateway"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Connections       ok"));
    EXPECT_THAT(run.out, HasSubstr("The gateway closes the connection after each answer"));
    const CliRun json = RingProject(2).run(wordsOf("gateway --json"), peer.link());
    EXPECT_EQ(outcomesOf(json).back(), "closing passed");
}

TEST(CliGateway, OneDeviceIsReadAlone)
{
    GatewayPeer peer;
    const CliRun run = RingProject().run(wordsOf("gateway 3.0"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("IN from register 4: 0000h 0BB8h"));
    EXPECT_THAT(run.out, HasSubstr("*  ABCD  00000BB8"));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("Word of 1.0")));
    EXPECT_EQ(RingProject().run(wordsOf("gateway 9.0"), peer.link()).exit, 2);
}

TEST(CliGateway, TheWrongWordOrderIsFoundOut)
{
    GatewayPeer peer(wordsOf("--devices 1 --low-word-first"));
    const CliRun run = RingProject(1).run(wordsOf("gateway"), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("but this one: IN from register 0, low word first."));
    EXPECT_EQ(RingProject(1).run(wordsOf("gateway"), peer.link(wordsOf("order=low"))).exit, 0);
}

TEST(CliGateway, ExchangedBytesAreFoundOut)
{
    GatewayPeer peer(wordsOf("--devices 2 --exchange-bytes"));
    const CliRun run = RingProject(2).run(wordsOf("gateway --json"), peer.link());
    EXPECT_EQ(stepOf(run, 5)[u"readings"][2][u"word"].toString(), wordsOf("000003E8"));
    EXPECT_EQ(stepOf(run, 5)[u"readings"][2][u"plausibility"].toString(), wordsOf("fits"));
}

TEST(CliGateway, SaysWhereItEnds)
{
    GatewayPeer peer(wordsOf("--registers 4"));
    const CliRun run = RingProject().run(wordsOf("gateway"), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("ends before the registers of 3.0, which begin at 4"));
    EXPECT_THAT(run.out, HasSubstr("Word of 1.0       ok"));
}

TEST(CliGateway, AWrongUnitAndANobodyAreSaid)
{
    GatewayPeer peer(wordsOf("--unit 5"));
    const CliRun unit =
        RingProject().run(wordsOf("gateway --json"), peer.link(wordsOf("time-out=300,retries=0")));
    EXPECT_EQ(unit.exit, 1);
    EXPECT_EQ(stepOf(unit, 2)[u"outcome"].toString(), wordsOf("failed"));
    EXPECT_EQ(stepOf(unit, 3)[u"outcome"].toString(), wordsOf("skipped"));
    const CliRun nobody = RingProject().run(wordsOf("gateway --json"), wordsOf("modbus-tcp:127.0.0.1:1"));
    EXPECT_EQ(errorKey(nobody), "connectionRefused");
    EXPECT_EQ(stepOf(nobody, 0)[u"outcome"].toString(), wordsOf("passed"));
}

TEST(CliGateway, WithoutAProjectTheUnitIsTested)
{
    GatewayPeer peer;
    const CliRun run = runLine(QStringLiteral("gateway --json --link ") + peer.link());
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "gatewayHasNoDevices");
    EXPECT_EQ(stepOf(run, 2)[u"outcome"].toString(), wordsOf("passed"));
}

TEST(CliGateway, OtherBusesHaveNone)
{
    EXPECT_EQ(errorKey(runLine(wordsOf("gateway --json"))), "noGateway");
    EXPECT_EQ(errorKey(runLine(wordsOf("gateway --json --link esc:training"))), "noSuchBus");
}

} // namespace
} // namespace codewheel
