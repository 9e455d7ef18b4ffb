// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_load.h"
#include "can/simulator/simulated_can_link.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

#include <gtest/gtest.h>
#include <set>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;

class BackgroundOfPlant : public testing::Test
{
protected:
    void SetUp() override { ASSERT_TRUE(m_link.open(CanUse::watch)); }

    std::vector<CanFrame> receive(Instant time)
    {
        std::vector<CanFrame> frames;
        const Instant until = m_link.now() + time;
        while (m_link.now() < until) {
            const auto news = m_link.receive(until);
            if (!news)
                break;
            frames.insert(frames.end(), news->frames.begin(), news->frames.end());
        }
        return frames;
    }
    double load()
    {
        CanLoad load(125'000);
        for (const CanFrame &frame : receive(2s))
            load.add(frame);
        return load.share(m_link.now());
    }
    std::set<std::uint32_t> identifiers(Instant time)
    {
        std::set<std::uint32_t> all;
        for (const CanFrame &frame : receive(time))
            all.insert(frame.id);
        return all;
    }

    SimulatedCanopenPlant m_plant;
    SimulatedCanLink m_link{m_plant.bus()};
};

TEST_F(BackgroundOfPlant, TakesAsMuchOfTheBusAsItIsTold)
{
    EXPECT_LT(load(), 0.01);
    for (const int percent : {30, 70, 90}) {
        m_plant.setBackground({.load = percent});
        EXPECT_NEAR(load(), percent / 100.0, 0.03);
    }
    m_plant.setBackground({});
    receive(1s);
    EXPECT_LT(load(), 0.01);
}

TEST_F(BackgroundOfPlant, IsThatOfDevicesThatAreNoEncoders)
{
    receive(100ms);
    m_plant.setBackground({.load = 20});
    const auto heard = identifiers(1500ms);
    for (const std::uint32_t id : {0x1EEU, 0x2EEU, 0x1EFU, 0x2EFU, 0x1F0U, 0x2F0U, 0x76EU, 0x76FU, 0x770U})
        EXPECT_TRUE(heard.contains(id)) << std::hex << id;
    EXPECT_FALSE(heard.contains(0x080));
}

TEST_F(BackgroundOfPlant, AMasterSendsSyncAndAsks)
{
    receive(100ms);
    m_plant.setBackground({.hasMaster = true});
    const auto frames = receive(2s);
    EXPECT_NEAR(static_cast<double>(std::ranges::count(frames, 0x080U, &CanFrame::id)), 20, 1);
    EXPECT_EQ(std::ranges::count(frames, 0x66EU, &CanFrame::id), 2);
    EXPECT_EQ(std::ranges::count(frames, 0x5EEU, &CanFrame::id), 2);
}

} // namespace
} // namespace codewheel::canopen
