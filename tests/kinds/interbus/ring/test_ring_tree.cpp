// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_tree.h"
#include "tests/kinds/interbus/ring/ring_builder.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Places = std::vector<std::size_t>;

TEST(RingTree, ShowsLocalBusAndBranchBelowTheirBusTerminal)
{
    const RingTree tree = ringTree(test::ring(test::plant()));
    EXPECT_EQ(tree.mainLine, (Places{0, 1, 9, 10, 11}));
    EXPECT_EQ(tree.nodes[1].localBus, (Places{2, 3}));
    EXPECT_EQ(tree.nodes[1].branch, (Places{4, 5, 8}));
    EXPECT_EQ(tree.nodes[5].localBus, (Places{6}));
    EXPECT_EQ(tree.nodes[5].branch, (Places{7}));
    EXPECT_TRUE(tree.nodes[10].isLeaf());
    EXPECT_EQ(tree.rowOf(8), 2u);
    EXPECT_TRUE(tree.hangsBelow(7, 1));
    EXPECT_TRUE(tree.hangsBelow(5, 5));
    EXPECT_FALSE(tree.hangsBelow(9, 1));
}

TEST(RingTree, NumbersFollowFromTheRingOrder)
{
    RingStructure structure = test::ring(test::plant());
    const RingTree tree = ringTree(structure);
    for (RingDevice &device : structure) {
        device.number = {};
        device.level = 0;
    }
    EXPECT_EQ(test::texts(numbered(tree, structure)), test::plant());
}

TEST(RingTree, ABranchIsCountedBeforeTheLevelGoesOn)
{
    RingStructure structure = test::ring(
        {QStringLiteral("1.0 T"), QStringLiteral("2.0 1"), QStringLiteral("3.0 1"), QStringLiteral("4.0")});
    RingTree tree = ringTree(structure);
    std::swap(tree.mainLine[0], tree.mainLine[1]);
    EXPECT_EQ(test::texts(numbered(tree, structure)),
              (QStringList{QStringLiteral("1.0"), QStringLiteral("2.0 T"), QStringLiteral("3.0 1"),
                           QStringLiteral("4.0 1")}));
}

TEST(RingTree, WhatHangsNowhereIsKept)
{
    for (const QStringList &odd :
         {QStringList{QStringLiteral("3.1")}, QStringList{QStringLiteral("1.0 3"), QStringLiteral("2.0")},
          QStringList{QStringLiteral("1.0"), QStringLiteral("5.1"), QStringLiteral("2.0 7")}}) {
        const RingStructure structure = test::ring(odd);
        Places order = ringTree(structure).order();
        std::ranges::sort(order);
        EXPECT_EQ(order.size(), structure.size());
        EXPECT_TRUE(std::ranges::adjacent_find(order) == order.end());
        EXPECT_EQ(numbered(ringTree(structure), structure).size(), structure.size());
    }
}

} // namespace
} // namespace codewheel
