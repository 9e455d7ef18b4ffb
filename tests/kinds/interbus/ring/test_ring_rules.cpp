// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_rules.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/kinds/interbus/ring/ring_builder.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

RingDevice device(DeviceNumber number, int level, unsigned idCode, int words)
{
    return {number.node(), 0x0100 | idCode, words, words, {}, level};
}

// A terminal with this many devices on its local bus, one word each.
RingStructure localBus(int count)
{
    RingStructure structure{device({1, 0}, 0, busTerminalIdCode, 0)};
    for (int position = 1; position <= count; ++position)
        structure.push_back(device({1, position}, 0, 0xBE, 1));
    return structure;
}

RingStructure mainLine(int count, unsigned idCode, int words)
{
    RingStructure structure;
    for (int segment = 1; segment <= count; ++segment)
        structure.push_back(device({segment, 0}, 0, idCode, words));
    return structure;
}

// Each level is one terminal deeper than the previous one.
RingStructure levels(int count)
{
    RingStructure structure;
    for (int level = 0; level < count; ++level)
        structure.push_back(device({level + 1, 0}, level, busTerminalIdCode, 0));
    return structure;
}

// 512 devices and more, within all other limits: terminals with full local buses of devices without data.
RingStructure many(int count)
{
    RingStructure structure;
    for (int segment = 1; std::ssize(structure) < count; ++segment) {
        structure.push_back(device({segment, 0}, 0, busTerminalIdCode, 0));
        for (int position = 1; position <= 63 && std::ssize(structure) < count; ++position)
            structure.push_back(device({segment, position}, 0, 0xBE, 0));
    }
    return structure;
}

struct Case
{
    const char *what;
    RingStructure within;
    RingStructure beyond;
    RingRule rule;
    std::size_t device; // the first that breaks the rule
    int count;
    int limit;
};

TEST(RingRules, HoldUpToTheLimitAndTellTheFirstDeviceBeyond)
{
    const std::vector<Case> cases{
        {"devices", many(512), many(513), RingRule::devices, 512, 513, 512},
        {"remote", mainLine(254, 0x0C, 0), mainLine(255, 0x0C, 0), RingRule::remoteDevices, 254, 255, 254},
        {"levels", levels(16), levels(17), RingRule::levels, 16, 17, 16},
        {"local bus", localBus(63), localBus(64), RingRule::localDevices, 64, 64, 63},
        {"PCP", mainLine(62, 0xE3, 0), mainLine(63, 0xE3, 0), RingRule::pcpDevices, 62, 63, 62},
    };
    for (const Case &c : cases) {
        EXPECT_TRUE(checkRing(c.within).empty()) << c.what;
        const std::vector<RingFinding> found = checkRing(c.beyond);
        ASSERT_EQ(found.size(), 1u) << c.what;
        EXPECT_EQ(found.front(), (RingFinding{c.rule, c.device, c.count, c.limit})) << c.what;
    }
}

TEST(RingRules, A4096PointsAre128EncodersK3)
{
    EXPECT_TRUE(checkRing(mainLine(128, 0x37, 2)).empty());
    const std::vector<RingFinding> found = checkRing(mainLine(129, 0x37, 2));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], (RingFinding{RingRule::inPoints, 128, 4128, 4096}));
    EXPECT_EQ(found[1], (RingFinding{RingRule::outPoints, 128, 4128, 4096}));
}

TEST(RingRules, LocalBusAndBranchNeedABusTerminal)
{
    const auto rulesOf = [](const QStringList &texts) {
        std::vector<RingRule> rules;
        for (const RingFinding &finding : checkRing(test::ring(texts)))
            rules.push_back(finding.rule);
        return rules;
    };
    EXPECT_TRUE(rulesOf(test::plant()).empty());
    EXPECT_EQ(rulesOf({QStringLiteral("1.0"), QStringLiteral("1.1")}),
              std::vector{RingRule::localBusNeedsTerminal});
    EXPECT_EQ(rulesOf({QStringLiteral("1.1")}), std::vector{RingRule::localBusNeedsTerminal});
    EXPECT_EQ(rulesOf({QStringLiteral("1.0"), QStringLiteral("2.0 1")}),
              std::vector{RingRule::branchNeedsTerminal});
    EXPECT_EQ(rulesOf({QStringLiteral("1.0 T"), QStringLiteral("1.1 T")}),
              std::vector{RingRule::terminalOnLocalBus});
}

TEST(RingRules, SayInWordsWhatIsWrong)
{
    const RingStructure structure = localBus(64);
    EXPECT_EQ(ringFindingText(checkRing(structure).front(), structure),
              QStringLiteral("A local bus has at most 63 devices; that of segment 1 has 64."));
    const RingStructure orphan = test::ring({QStringLiteral("1.0"), QStringLiteral("1.1")});
    EXPECT_EQ(ringFindingText(checkRing(orphan).front(), orphan),
              QStringLiteral("1.1 is on a local bus, which needs a bus terminal."));
}

TEST(RingRules, CountWhatThereIs)
{
    const RingCounts counts = countRing(test::ring(test::plant()));
    EXPECT_EQ(counts.devices, 12);
    EXPECT_EQ(counts.remoteDevices, 9);
    EXPECT_EQ(counts.levels, 3);
    EXPECT_EQ(counts.inPoints, 9 * 32);
    EXPECT_EQ(counts.outPoints, 9 * 32);
    EXPECT_EQ(counts.longestLocalBus, 2);
    EXPECT_EQ(counts.pcpDevices, 0);
}

} // namespace
} // namespace codewheel
