// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/channel_blocks.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class ChannelBlocksTest : public testing::Test
{
protected:
    std::vector<Sample> written(qint64 block)
    {
        const auto found = changes.blocks.find(block);
        return found == changes.blocks.end() ? std::vector<Sample>()
                                             : unpackBlock(found->second.data)->samples;
    }

    RecordingChanges changes;
    qint64 nextBlock = 1;
    ChannelBlocks blocks{7, 3, Channel::position, nextBlock};
};

TEST_F(ChannelBlocksTest, WhileTheValueStandsNothingIsWritten)
{
    for (int i = 0; i < 1'000; ++i)
        blocks.append({1ms * i, 5}, changes);
    blocks.write(changes);
    EXPECT_THAT(written(1), ElementsAre(Sample{0ms, 5}));
    changes = {};
    for (int i = 1'000; i < 100'000; ++i)
        blocks.append({1ms * i, 5}, changes);
    blocks.write(changes);
    EXPECT_TRUE(changes.blocks.empty());
    blocks.append({100s, 6}, changes);
    blocks.write(changes);
    EXPECT_THAT(written(2), ElementsAre(Sample{99'999ms, 5}, Sample{100s, 6})) << "until when it stood";
}

TEST_F(ChannelBlocksTest, ABlockWithRoomIsWrittenAgainWithWhatFollows)
{
    blocks.append({1ms, 1}, changes);
    blocks.write(changes);
    blocks.append({2ms, 2}, changes);
    blocks.write(changes);
    EXPECT_THAT(written(1), ElementsAre(Sample{1ms, 1}, Sample{2ms, 2}));
    EXPECT_EQ(nextBlock, 2);
}

TEST_F(ChannelBlocksTest, ABlockEndsOnceItHasEnoughOrLastedLongEnough)
{
    for (std::size_t i = 0; i < ChannelBlocks::enough; ++i)
        blocks.append({1ms * i, static_cast<std::int64_t>(i)}, changes);
    blocks.write(changes);
    blocks.append({2s, -1}, changes);
    blocks.append({13s, -2}, changes);
    blocks.write(changes);
    EXPECT_EQ(written(1).size(), ChannelBlocks::enough);
    EXPECT_THAT(written(2), ElementsAre(Sample{2s, -1}));
    EXPECT_THAT(written(3), ElementsAre(Sample{13s, -2}));
}

TEST_F(ChannelBlocksTest, WhatCameAtOnceIsSeveralBlocks)
{
    for (std::size_t i = 0; i <= RecordedBlock::most; ++i)
        blocks.append({1ms * i, static_cast<std::int64_t>(i)}, changes);
    blocks.write(changes);
    EXPECT_EQ(written(1).size(), RecordedBlock::most);
    EXPECT_EQ(written(2).size(), 1U);
}

TEST_F(ChannelBlocksTest, AGapIsKnownWhileItLastsAndKeptBeforeTheNextSample)
{
    blocks.append({1ms, 1}, changes);
    blocks.append({2ms, 1}, changes);
    blocks.append({3ms, 1}, changes);
    blocks.interrupt(4ms, changes);
    blocks.interrupt(5ms, changes);
    EXPECT_EQ(changes.channels.at(7).gapSince, Instant(4ms));
    blocks.append({9ms, 1}, changes);
    blocks.write(changes);
    EXPECT_FALSE(changes.channels.at(7).gapSince);
    const auto block = unpackBlock(changes.blocks.at(1).data);
    EXPECT_THAT(block->samples, ElementsAre(Sample{1ms, 1}, Sample{3ms, 1}, Sample{9ms, 1}));
    EXPECT_THAT(block->gaps, ElementsAre(RecordedBlock::GapBefore{2, 4ms}));
    EXPECT_TRUE(changes.blocks.at(1).piece.column.hasGap);
}

TEST_F(ChannelBlocksTest, WhatIsOlderIsLeftOut)
{
    blocks.interrupt(1ms, changes); // nothing was known anyway
    blocks.append({5ms, 1}, changes);
    blocks.append({4ms, 2}, changes);
    blocks.interrupt(8ms, changes);
    blocks.append({7ms, 3}, changes);
    blocks.write(changes);
    EXPECT_THAT(written(1), ElementsAre(Sample{5ms, 1}));
}

TEST_F(ChannelBlocksTest, MinutesAndHoursAreWrittenOnceTheyAreOver)
{
    for (int second = 0; second < 2 * 3600 + 90; second += 5)
        blocks.append({1s * second, second}, changes), blocks.write(changes);
    std::vector<SummaryRow> hours;
    std::size_t minutes = 0;
    for (const SummaryRow &row : changes.summaries) {
        if (row.piece.length == Instant(1h))
            hours.push_back(row);
        else
            ++minutes;
    }
    ASSERT_EQ(hours.size(), 2U);
    EXPECT_EQ(minutes, 121U);
    EXPECT_EQ(hours[1].piece.from, Instant(1h));
    EXPECT_EQ(hours[1].piece.column.summary.extent.least, 3600);
    EXPECT_GE(hours[1].piece.column.summary.extent.greatest, 7195);
    EXPECT_EQ(hours[1].piece.column.first, 3600);
}

} // namespace
} // namespace codewheel
