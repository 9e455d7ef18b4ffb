// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_edit.h"
#include "kinds/interbus/ring/ring_rules.h"
#include "tests/kinds/interbus/ring/ring_builder.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

using test::plant;
using test::ring;
using test::texts;

RingDevice encoder()
{
    return test::participant(QStringLiteral("1.0"));
}

struct Insertion
{
    const char *what;
    RingPlace place;
    std::vector<int> order; // -1: the new one
    const char *number;
    int level;
};

TEST(RingEdit, ADeviceIsInsertedAnywhere)
{
    const std::vector<Insertion> table{
        {"at the start", {{}, false, 0}, {-1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, "1.0", 0},
        {"behind a branch", {{}, false, 2}, {0, 1, 2, 3, 4, 5, 6, 7, 8, -1, 9, 10, 11}, "7.0", 0},
        {"at the end", {{}, false, 99}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, -1}, "10.0", 0},
        {"on a local bus", {1, true, 1}, {0, 1, 2, -1, 3, 4, 5, 6, 7, 8, 9, 10, 11}, "2.2", 0},
        {"behind a local bus", {1, true, 9}, {0, 1, 2, 3, -1, 4, 5, 6, 7, 8, 9, 10, 11}, "2.3", 0},
        {"into a branch", {1, false, 0}, {0, 1, 2, 3, -1, 4, 5, 6, 7, 8, 9, 10, 11}, "3.0", 1},
        {"two levels deep", {5, false, 1}, {0, 1, 2, 3, 4, 5, 6, 7, -1, 8, 9, 10, 11}, "6.0", 2},
        {"a new branch", {10, false, 0}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, -1, 11}, "9.0", 1},
        {"a new local bus", {10, true, 0}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, -1, 11}, "8.1", 0},
    };
    for (const Insertion &row : table) {
        const auto done = insertDevice(ring(plant()), encoder(), row.place);
        ASSERT_TRUE(done.has_value()) << row.what;
        std::vector<int> order;
        for (const auto &from : done->from)
            order.push_back(from ? static_cast<int>(*from) : -1);
        EXPECT_EQ(order, row.order) << row.what;
        const auto place = static_cast<std::size_t>(std::ranges::find(order, -1) - order.begin());
        EXPECT_EQ(done->structure[place].number.toString(), QLatin1String(row.number)) << row.what;
        EXPECT_EQ(done->structure[place].level, row.level) << row.what;
    }
}

TEST(RingEdit, WithADeviceGoesAllThatHangsBelow)
{
    const auto edited = removeDevices(ring(plant()), std::vector<std::size_t>{1});
    ASSERT_TRUE(edited);
    EXPECT_EQ(texts(edited->structure), (QStringList{QStringLiteral("1.0"), QStringLiteral("2.0"),
                                                     QStringLiteral("3.0 T"), QStringLiteral("4.0")}));
}

TEST(RingEdit, SeveralDevicesAreRemovedAtOnce)
{
    const auto edited = removeDevices(ring(plant()), std::vector<std::size_t>{5, 7, 0, 2});
    ASSERT_TRUE(edited);
    EXPECT_EQ(texts(edited->structure),
              (QStringList{QStringLiteral("1.0 T"), QStringLiteral("1.1"), QStringLiteral("2.0 1"),
                           QStringLiteral("3.0 1"), QStringLiteral("4.0"), QStringLiteral("5.0 T"),
                           QStringLiteral("6.0")}));
}

struct Move
{
    const char *what;
    std::vector<std::size_t> devices;
    RingPlace place;
    std::vector<std::size_t> order;
};

TEST(RingEdit, DevicesMoveWithAllThatHangsBelow)
{
    const std::vector<Move> table{
        {"down", {0}, {{}, false, 3}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 10, 11}},
        {"up", {9}, {{}, false, 1}, {0, 9, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11}},
        {"where it stands", {9}, {{}, false, 2}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
        {"behind itself", {9}, {{}, false, 3}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
        {"a terminal", {1}, {{}, false, 99}, {0, 9, 10, 11, 1, 2, 3, 4, 5, 6, 7, 8}},
        {"into a branch", {0}, {1, false, 1}, {1, 2, 3, 4, 0, 5, 6, 7, 8, 9, 10, 11}},
        {"onto a local bus", {0}, {1, true, 0}, {1, 0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
        {"a branch elsewhere", {5}, {10, false, 0}, {0, 1, 2, 3, 4, 8, 9, 10, 5, 6, 7, 11}},
        {"two at once", {0, 11}, {{}, false, 2}, {1, 2, 3, 4, 5, 6, 7, 8, 0, 11, 9, 10}},
        {"one with its child", {1, 2}, {{}, false, 0}, {1, 2, 3, 4, 5, 6, 7, 8, 0, 9, 10, 11}},
    };
    const RingStructure before = ring(plant());
    for (const Move &row : table) {
        const auto edited = moveDevices(before, row.devices, row.place);
        ASSERT_TRUE(edited) << row.what;
        std::vector<std::size_t> order;
        for (const auto &from : edited->from)
            order.push_back(*from);
        EXPECT_EQ(order, row.order) << row.what;
        EXPECT_TRUE(checkRing(edited->structure).empty()) << row.what;
    }
}

TEST(RingEdit, WhatCannotBeIsRefusedInWords)
{
    const RingStructure before = ring(plant());
    const auto sentence = [](const Result<EditedRing> &edited) {
        return edited ? std::string() : refusalText(edited.error()).toStdString();
    };
    const std::vector<std::size_t> terminal{1};
    EXPECT_EQ(sentence(moveDevices(before, terminal, {5, false, 0})),
              "The bus cannot be built like this: 2.0 cannot hang below itself.");
    EXPECT_EQ(sentence(moveDevices(before, terminal, {10, true, 0})),
              "The bus cannot be built like this: A bus terminal belongs on the remote bus.");
    EXPECT_EQ(sentence(insertDevice(before, encoder(), {0, true, 0})),
              "The bus cannot be built like this: Nothing can hang below 1.0: it is not a bus terminal.");
    EXPECT_EQ(sentence(insertDevice(before, encoder(), {{}, true, 0})),
              "The bus cannot be built like this: A local bus needs a bus terminal.");
    EXPECT_EQ(sentence(changeDevice(before, 1, encoder())),
              "The bus cannot be built like this: Devices hang below 2.0, so it has to stay a bus terminal.");
}

TEST(RingEdit, WhatIsOverALimitAlreadyMayBeMadeSmaller)
{
    RingStructure before;
    for (int segment = 1; segment <= 260; ++segment)
        before.push_back(test::participant(QStringLiteral("%1.0 T").arg(segment)));
    EXPECT_TRUE(removeDevices(before, std::vector<std::size_t>{7}));
    EXPECT_TRUE(moveDevices(before, std::vector<std::size_t>{7}, {{}, false, 0}));
    EXPECT_FALSE(insertDevice(before, test::participant(QStringLiteral("1.0 T")), {{}, false, 0}));
}

// Whatever is done: nothing is lost, no rule is broken, and what does not change keeps its place.
TEST(RingEdit, RandomEditsNeverBreakARule)
{
    std::mt19937 random(4);
    const auto below = [&](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    RingStructure structure = ring(plant());
    int done = 0;
    for (int step = 0; step < 3'000; ++step) {
        const bool grows = structure.size() < 40;
        RingPlace place{.terminal = {}, .onLocalBus = below(2) == 0, .row = below(6)};
        if (!structure.empty() && below(3) != 0)
            place.terminal = below(structure.size());
        const std::size_t kind = structure.empty() ? 0 : below(4);
        Result<EditedRing> edited =
            kind <= (grows ? 1U : 0U) ? insertDevice(structure,
                                                     test::participant(below(3) == 0 ? QStringLiteral("1.0 T")
                                                                                     : QStringLiteral("1.0")),
                                                     place)
            : kind == 2
                ? moveDevices(structure, std::vector{below(structure.size()), below(structure.size())}, place)
                : removeDevices(structure, std::vector{below(structure.size())});
        if (!edited)
            continue;
        ++done;
        ASSERT_EQ(edited->from.size(), edited->structure.size());
        for (std::size_t i = 0; i < edited->from.size(); ++i)
            if (const auto from = edited->from[i]) {
                ASSERT_EQ(edited->structure[i].idCode(), structure[*from].idCode());
            }
        ASSERT_TRUE(checkRing(edited->structure).empty())
            << texts(edited->structure).join(u' ').toStdString();
        structure = std::move(edited->structure);
    }
    EXPECT_GT(done, 500);
}

} // namespace
} // namespace codewheel
