// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_line_address.h"
#include "vocabulary/place.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

std::vector<NodeId> nodes(std::initializer_list<const char *> texts)
{
    std::vector<NodeId> made;
    for (const char *text : texts)
        made.emplace_back(text);
    return made;
}

TEST(NodeId, StandsInOrderNumberByNumber)
{
    const std::vector<NodeId> ring = nodes({"1.0", "2.0", "2.1", "2.2", "2.10", "10.0", "254.63"});
    EXPECT_TRUE(std::ranges::is_sorted(ring));
    const std::vector<NodeId> line = nodes({"esc:00", "esc:01", "esc:0A", "esc:12", "esc:1F"});
    EXPECT_TRUE(std::ranges::is_sorted(line));
    EXPECT_LT(NodeId(), NodeId("1.0"));
    EXPECT_LT(NodeId("1"), NodeId("1.0"));
    EXPECT_EQ(NodeId("1.0") <=> NodeId("1.0"), std::strong_ordering::equal);
}

TEST(NodeId, IsShort)
{
    EXPECT_EQ(NodeId("esc:1F").toString(), QStringLiteral("esc:1F"));
    EXPECT_TRUE(NodeId().isEmpty());
    EXPECT_EQ(NodeId("123456789012").toString(), QStringLiteral("12345678901")) << "cut off";
}

TEST(Place, IsOfOneBus)
{
    const Place one{firstBus, NodeId("1.0")};
    const Place other{BusId{7}, NodeId("1.0")};
    EXPECT_NE(one, other);
    EXPECT_LT((Place{firstBus, NodeId("2.0")}), other) << "bus by bus";
    EXPECT_TRUE((Place{firstLine, {}}.isEmpty()));
}

TEST(Place, IsKeptWithTheNumberOfItsBus)
{
    EXPECT_EQ((Place{firstBus, NodeId("6.1")}.key()), QStringLiteral("6.1"));
    EXPECT_EQ((Place{firstLine, NodeId("esc:12")}.key()), QStringLiteral("esc:12"));
    EXPECT_EQ((Place{BusId{4}, NodeId("esc:12")}.key()), QStringLiteral("4/esc:12"));
    EXPECT_EQ((Place{firstBus, NodeId("esc:12")}.key()), QStringLiteral("1/esc:12"))
        << "whatever the first bus of a project is";
    for (const Place place : {Place{firstBus, NodeId("6.1")}, Place{firstLine, NodeId("esc:12")},
                              Place{BusId{4}, NodeId("esc:12")}, Place{firstBus, NodeId("esc:12")}})
        EXPECT_EQ(Place::parse(place.key()), place);
    for (const char16_t *wrong : {u"/1.0", u"0/1.0", u"-3/1.0", u"x/1.0", u"3/"})
        EXPECT_FALSE(Place::parse(wrong)) << QString::fromUtf16(wrong).toStdString();
}

TEST(Place, OfABusItselfHasAKeyToo)
{
    EXPECT_EQ((Place{BusId{3}, {}}.key()), QStringLiteral("3/"));
    EXPECT_EQ(Place::ofKey(u"3/"), (Place{BusId{3}, {}}));
    EXPECT_EQ(Place::ofKey(u"6.1"), (Place{firstBus, NodeId("6.1")}));
    for (const char16_t *wrong : {u"/", u"0/", u"-3/", u"x/", u"3//", u""})
        EXPECT_FALSE(Place::ofKey(wrong)) << QString::fromUtf16(wrong).toStdString();
}

TEST(Place, IsToldWithTheNameOfItsBusWhereAnotherMayHaveItToo)
{
    const Place place{BusId{3}, NodeId("1.0")};
    EXPECT_EQ(place.shown(), QStringLiteral("1.0"));
    setBusNames({{firstBus, QStringLiteral("Ring")}, {BusId{3}, QStringLiteral("Crane 2")}});
    EXPECT_EQ(place.shown(), QStringLiteral("Crane 2/1.0"));
    EXPECT_EQ(place.toString(), QStringLiteral("1.0"));
    EXPECT_EQ((Place{firstLine, NodeId("esc:12")}.shown()), QStringLiteral("esc:12"));
    setBusNames({});
    EXPECT_EQ(place.shown(), QStringLiteral("1.0"));
}

TEST(Place, IsReadAsItIsTyped)
{
    EXPECT_EQ(Place::parse(u"6.1"), (Place{firstBus, NodeId("6.1")}));
    const Place twelve{firstLine, NodeId("esc:12")};
    EXPECT_EQ(Place::parse(u"12"), twelve);
    EXPECT_EQ(Place::parse(u"esc:12"), twelve);
    EXPECT_EQ(Place::parse(u"1f"), placeOnLine({31}));
    EXPECT_TRUE(twelve.isAddress());
    EXPECT_FALSE(Place::parse(u"1.2")->isAddress());
}

// Manual, "Masteraddress: 00": the place of an encoder alone on its line, not a missing place.
TEST(Place, MayBeTheMasterAddressOfASerialLine)
{
    const Place alone = placeOnLine(EscLineAddress::master());
    EXPECT_TRUE(alone.isAddress());
    EXPECT_FALSE(alone.isEmpty());
    EXPECT_EQ(Place::parse(u"00"), alone);
    EXPECT_EQ(Place::parse(u"esc:00"), alone);
}

TEST(Place, AnythingElseIsNone)
{
    for (const QStringView text :
         {u"", u"1", u"1.", u".0", u"0.0", u"+1.0", u"1.0 ", u"1,0", u"-1.0", u"1.0.0", u"1234.0", u"20",
          u"012", u"esc:", u"esc:0", u"esc:1.0", u"1G", u"esc:+1"})
        EXPECT_FALSE(Place::parse(text)) << text.toString().toStdString();
}

} // namespace
} // namespace codewheel
