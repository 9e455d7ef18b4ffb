// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/done_jobs.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(DoneJobs, TheJobOnItsWayIsSeenBehindThoseThatAreDone)
{
    DoneJobs done;
    const Step written{.effect = Effect::takes, .out = 0xC200'1388};
    const Step set{.effect = Effect::takes, .out = 0xC600'03E8};
    Outcome first;
    first.eepromWrites = 1;
    first.positionBefore = 4661;
    first.positionAfter = 4662;
    first.written = {{Parameter::measuringLength, 5000}};
    done.add(Progress{.steps = {written}, .confirmed = {}, .setsPosition = true}, first);

    const Progress progress =
        done.followedBy(Progress{.job = 2, .index = 0, .steps = {set}, .confirmed = {}, .canRestore = true});
    EXPECT_EQ(progress.index, 1);
    EXPECT_EQ(progress.steps, (std::vector{written, set}));
    EXPECT_FALSE(progress.canRestore) << "the job on its way knows nothing of the one before";

    Outcome last;
    last.job = 2;
    last.eepromWrites = 1;
    last.leftIn = EncoderState::operation;
    last.positionAfter = 1000;
    const Outcome all = done.followedBy(last);
    EXPECT_EQ(all.job, 2U);
    EXPECT_EQ(all.eepromWrites, 2);
    EXPECT_EQ(all.written, first.written);
    EXPECT_EQ(all.positionBefore, 4661);
    EXPECT_EQ(all.positionAfter, 1000);
    EXPECT_FALSE(all.isPositionSet) << "told of those that failed";

    last.result = refuse(RefusalKind::device, RefusalId::encoderSilent);
    EXPECT_TRUE(done.followedBy(last).isPositionSet);
}

TEST(DoneJobs, OneJobAloneIsToldAsItIs)
{
    const Progress progress = DoneJobs().followedBy(
        Progress{.job = 1, .index = 3, .steps = {}, .confirmed = {}, .canRestore = true});
    EXPECT_EQ(progress.index, 3);
    EXPECT_TRUE(progress.canRestore);
}

} // namespace
} // namespace codewheel
