// SPDX-License-Identifier: GPL-3.0-or-later
// What the user is told of the clients of an offered ring, and where its devices are in the registers.
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/offer_messages.h"
#include "kinds/interbus/gateway/served_news.h"
#include "kinds/interbus/gateway/served_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class ServedNewsTest : public testing::Test
{
protected:
    static constexpr std::size_t mostClients = 4;

    std::vector<MessageCode> idsAt(Instant at)
    {
        said = news.take(clients, at);
        std::vector<MessageCode> ids;
        for (const Message &message : said)
            ids.push_back(message.id);
        return ids;
    }
    void comeAndGo(int times)
    {
        for (int i = 0; i < times; ++i)
            clients.leave(*clients.come(QStringLiteral("127.0.0.1:5"), {}));
    }
    static std::vector<RefusalArgument> counts(std::int64_t came, std::int64_t left, std::int64_t refused)
    {
        return {came, left, refused};
    }

    ServedClients clients{mostClients};
    ServedNews news;
    std::vector<Message> said;
};

TEST_F(ServedNewsTest, FewAreToldOneByOne)
{
    EXPECT_THAT(idsAt(0s), IsEmpty());
    const auto id = clients.come(QStringLiteral("10.0.0.7:50000"), {});
    EXPECT_THAT(idsAt(1s), ElementsAre(OfferMessageId::clientCame));
    EXPECT_EQ(said[0].arguments, std::vector<RefusalArgument>{QStringLiteral("10.0.0.7:50000")});
    const ServedWord word{NodeId("1.0"), 7, {}};
    clients.took(*id, 1, {.pdu = {}, .isWrite = true, .written = word}, {});
    clients.took(*id, 1, {.pdu = {}}, {});
    clients.leave(*id);
    EXPECT_THAT(idsAt(2s), ElementsAre(OfferMessageId::clientLeft));
    EXPECT_EQ(said[0].arguments, (std::vector<RefusalArgument>{QStringLiteral("10.0.0.7:50000"),
                                                               std::int64_t{2}, std::int64_t{1}}));
}

TEST_F(ServedNewsTest, OfAThousandOnlyTheSumIsTold)
{
    comeAndGo(1'000); // more than the news that are kept
    EXPECT_EQ(idsAt(0s).size(), ServedNews::mostAlone);
    EXPECT_THAT(idsAt(9s), IsEmpty());
    EXPECT_THAT(idsAt(10s), ElementsAre(OfferMessageId::clientsPassed));
    const auto alone = static_cast<std::int64_t>(ServedNews::mostAlone) / 2;
    EXPECT_EQ(said[0].arguments, counts(1'000 - alone, 1'000 - alone, 0));
    EXPECT_EQ(said[0].severity, Severity::information);
    EXPECT_THAT(idsAt(30s), IsEmpty()) << "nothing is told twice";
}

TEST_F(ServedNewsTest, ASumAfterAnother)
{
    comeAndGo(100);
    idsAt(0s);
    comeAndGo(10);
    idsAt(10s);
    comeAndGo(200);
    EXPECT_EQ(idsAt(11s).size(), ServedNews::mostAlone - 1) << "the sum was one of them";
    EXPECT_THAT(idsAt(20s), ElementsAre(OfferMessageId::clientsPassed));
    const auto told = static_cast<std::int64_t>(ServedNews::mostAlone - 1);
    EXPECT_EQ(said[0].arguments, counts(200 - (told + 1) / 2, 200 - told / 2, 0));
}

TEST_F(ServedNewsTest, ThoseThatAreRefusedAreAnAttention)
{
    for (std::size_t i = 0; i < 100; ++i)
        clients.come(QStringLiteral("127.0.0.1:5"), {});
    idsAt(0s);
    EXPECT_EQ(said.back().id, OfferMessageId::clientRefused);
    EXPECT_EQ(said.back().severity, Severity::attention);
    EXPECT_THAT(idsAt(10s), ElementsAre(OfferMessageId::clientsPassed));
    EXPECT_EQ(said[0].arguments, counts(0, 0, 92));
    EXPECT_EQ(said[0].severity, Severity::attention);
}

TEST_F(ServedNewsTest, AfterAQuietTimeEachIsToldAgain)
{
    comeAndGo(2);
    EXPECT_EQ(idsAt(0s).size(), 4U);
    comeAndGo(4);
    EXPECT_EQ(idsAt(11s).size(), 8U);
}

TEST(ServedTable, EachDeviceHasItsRegistersInRingOrder)
{
    RingStructure ring(3);
    ring[0] = {.number = NodeId("1.0"), .deviceCode = 0x37, .inWords = 2, .outWords = 2, .deviceKey = {}};
    ring[1] = {.number = NodeId("2.0"), .deviceCode = 0x36, .inWords = 1, .outWords = 0, .deviceKey = {}};
    ring[2] = {.number = NodeId("2.1"), .deviceCode = 0x37, .inWords = 2, .outWords = 2, .deviceKey = {}};
    const auto table = servedTable(ring);
    ASSERT_EQ(table.size(), 3U);
    EXPECT_EQ(table[1].place, NodeId("2.0"));
    EXPECT_EQ(table[1].in, (RegisterBlock{2, 1}));
    EXPECT_EQ(table[1].inHolding, (RegisterBlock{4'098, 1}));
    EXPECT_EQ(table[1].out.count, 0);
    EXPECT_EQ(table[2].in, (RegisterBlock{3, 2}));
    EXPECT_EQ(table[2].out, (RegisterBlock{2, 2}));
}

// Who only holds a seat gives way to somebody who wants it.
class SilentClients : public ServedNewsTest
{
protected:
    static ServedClient::Time at(std::chrono::seconds time) { return ServedClient::Time(time); }
    unsigned come(const char *address, std::chrono::seconds time)
    {
        return clients.come(QString::fromLatin1(address), at(time)).value_or(0);
    }
    void ask(unsigned client, std::chrono::seconds time) { clients.took(client, 1, {.pdu = {}}, at(time)); }
};

TEST_F(SilentClients, NobodyGivesWayWhileThereIsRoom)
{
    come("10.0.0.1:1", 0s);
    EXPECT_EQ(clients.giveWay(at(1h)), std::nullopt);
}

TEST_F(SilentClients, TheLongestSilentOfTheAddressWithMostConnectionsGivesWay)
{
    come("10.0.0.1:1", 0s);
    const unsigned first = come("10.0.0.2:1", 1s);
    const unsigned second = come("10.0.0.2:2", 2s);
    const unsigned third = come("10.0.0.2:3", 3s);
    ask(first, 30s);
    EXPECT_EQ(clients.giveWay(at(60s)), second);
    EXPECT_EQ(clients.clients().size(), 3u);
    EXPECT_NE(come("10.0.0.3:1", 60s), 0u);
    EXPECT_EQ(clients.giveWay(at(61s)), third);
}

TEST_F(SilentClients, WhoHasJustAskedStays)
{
    for (const char *address : {"10.0.0.1:1", "10.0.0.1:2", "10.0.0.1:3", "10.0.0.1:4"})
        ask(come(address, 0s), 10s);
    EXPECT_EQ(clients.giveWay(at(12s)), std::nullopt);
    EXPECT_EQ(come("10.0.0.2:1", 12s), 0u) << "refused";
}

} // namespace
} // namespace codewheel
