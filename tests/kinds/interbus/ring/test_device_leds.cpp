// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/crc_history.h"
#include "kinds/interbus/ring/device_leds.h"

#include <gtest/gtest.h>
#include <numeric>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// FRABA manual 3.3
TEST(TheLedsOfADevice, FollowTheMaster)
{
    using enum LedLight;
    EXPECT_EQ(ledsOf(MasterState::ready, true), (DeviceLeds{on, on, off, off}));
    EXPECT_EQ(ledsOf(MasterState::active, true), (DeviceLeds{on, on, blinking, off}));
    EXPECT_EQ(ledsOf(MasterState::run, true), (DeviceLeds{on, on, on, off}));
    EXPECT_EQ(ledsOf(MasterState::busFail, true), (DeviceLeds{on, off, off, on}));
    EXPECT_EQ(ledsOf(MasterState::run, false), (DeviceLeds{on, off, off, on}));
    EXPECT_EQ(ledText(ledsOf(MasterState::active, true)).toStdString(),
              "UL on, RC on, BA blinking, RBDA off");
}

TEST(ACrcHistory, CountsByIntervalAndForgetsWhatIsOld)
{
    CrcHistory history;
    MasterStatus status;
    status.segments = {{.segment = 1}, {.segment = 2}};
    history.note(status, 1s);
    status.segments[1].crcErrors = 3;
    history.note(status, 5s);
    status.segments[1].crcErrors = 4;
    history.note(status, 15s);
    EXPECT_EQ(history.of(2).counts[28], 3U);
    EXPECT_EQ(history.of(2).counts[29], 1U);
    EXPECT_EQ(history.of(2).last, Instant(15s));
    EXPECT_EQ(history.of(1).last, std::nullopt);
    status.segments[1].crcErrors = 2; // counted since a new start
    history.note(status, 25s);
    EXPECT_EQ(history.of(2).counts[29], 2U);
    history.note(status, 20min);
    const auto counts = history.of(2).counts;
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0U), 0U);
    EXPECT_EQ(history.of(2).last, Instant(25s));
}

} // namespace
} // namespace codewheel
