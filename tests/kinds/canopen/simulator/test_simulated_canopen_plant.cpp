// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_link.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;

using Octets8 = std::array<std::uint8_t, 8>;

class CanopenPlant : public testing::Test
{
protected:
    void SetUp() override { ASSERT_TRUE(m_link.open(CanUse::operate)); }

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
    // The first frame with this identifier that follows; empty: none within 100 ms.
    std::optional<Octets8> ask(std::uint32_t identifier, const Octets8 &octets, std::uint32_t answer)
    {
        EXPECT_TRUE(m_link.send({.id = identifier, .length = 8, .bytes = octets}));
        for (const CanFrame &frame : receive(100ms))
            if (frame.id == answer)
                return frame.bytes;
        return std::nullopt;
    }

    SimulatedCanopenPlant m_plant;
    SimulatedCanLink m_link{m_plant.bus()};
};

TEST_F(CanopenPlant, ThreeTellOfBootUp)
{
    std::set<std::uint32_t> identifiers;
    for (const CanFrame &frame : receive(100ms))
        identifiers.insert(frame.id);
    EXPECT_EQ(identifiers, (std::set<std::uint32_t>{0x705, 0x706, 0x707}));
}

TEST_F(CanopenPlant, EachHasItsDeviceTypeAndSerialNumber)
{
    receive(100ms);
    const struct
    {
        std::uint32_t node;
        Octets8 type;
        Octets8 serialNumber;
    } rows[] = {
        {5, {0x43, 0x00, 0x10, 0, 0x96, 1, 1, 0}, {0x43, 0x18, 0x10, 4, 0x91, 0xD5, 0x12, 0}},
        {6, {0x43, 0x00, 0x10, 0, 0x96, 1, 2, 0}, {0x43, 0x18, 0x10, 4, 0xA4, 0xD5, 0x12, 0}},
        {7, {0x43, 0x00, 0x10, 0, 0x96, 1, 8, 0}, {0x43, 0x18, 0x10, 4, 0x08, 0x00, 0x13, 0}},
    };
    for (const auto &row : rows) {
        EXPECT_EQ(ask(0x600 + row.node, {0x40, 0x00, 0x10, 0}, 0x580 + row.node), row.type) << row.node;
        EXPECT_EQ(ask(0x600 + row.node, {0x40, 0x18, 0x10, 4}, 0x580 + row.node), row.serialNumber);
    }
}

TEST_F(CanopenPlant, StartedTheyTellTheirPositions)
{
    receive(100ms);
    EXPECT_TRUE(m_link.send({.id = 0, .length = 2, .bytes = {1, 0}}));
    const auto frames = receive(1s);
    const auto count = [&frames](std::uint32_t id) { return std::ranges::count(frames, id, &CanFrame::id); };
    EXPECT_EQ(count(0x185), 10);                            // it stands still, every 100 ms
    EXPECT_NEAR(static_cast<double>(count(0x186)), 100, 2); // inhibit time
    EXPECT_NEAR(static_cast<double>(count(0x187)), 100, 2);
    EXPECT_EQ(count(0x285), 0); // no SYNC
    const auto first = std::ranges::find(frames, 0x185U, &CanFrame::id);
    EXPECT_EQ(first->bytes, (Octets8{0x88, 0x13}));
}

TEST_F(CanopenPlant, TheOneWithoutANumberIsSelectedByItsIdentity)
{
    receive(100ms);
    EXPECT_EQ(ask(0x7E5, {0x51, 0, 0, 0, 0, 0x80}, 0x7E4), Octets8{0x4F});
    ask(0x7E5, {0x40, 0x0D, 0x01}, 0x7E4);
    ask(0x7E5, {0x41, 0x25}, 0x7E4);
    ask(0x7E5, {0x42, 0x01, 0x00, 0x01}, 0x7E4);
    EXPECT_EQ(ask(0x7E5, {0x43, 0x15, 0x00, 0x13}, 0x7E4), Octets8{0x44});
    EXPECT_EQ(ask(0x7E5, {0x11, 8}, 0x7E4), Octets8{0x11});
    EXPECT_EQ(ask(0x7E5, {0x17}, 0x7E4), Octets8{0x17});
    EXPECT_EQ(ask(0x7E5, {0x04, 0}, 0x708), Octets8{}); // boot-up
    EXPECT_EQ(ask(0x608, {0x40, 0x04, 0x60}, 0x588), (Octets8{0x43, 0x04, 0x60, 0, 0x00, 0x2D, 0x31, 0x01}));
    m_plant.withEncoder(3, [](SimulatedNode &node) {
        EXPECT_EQ(node.node(), 8);
        EXPECT_EQ(node.eepromWrites(), 1U);
    });
}

TEST_F(CanopenPlant, WithoutPowerNobodyAnswers)
{
    receive(100ms);
    m_plant.withEncoder(0, [](SimulatedNode &node) { node.setOn(false); });
    EXPECT_FALSE(ask(0x605, {0x40, 0x00, 0x10}, 0x585));
    m_plant.withEncoder(0, [](SimulatedNode &node) { node.setOn(true); });
    const auto frames = receive(100ms);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames.front().id, 0x705U);
    EXPECT_TRUE(ask(0x605, {0x40, 0x00, 0x10}, 0x585));
}

TEST_F(CanopenPlant, AtTheNewRateItIsNotReached)
{
    receive(100ms);
    EXPECT_EQ(ask(0x7E5, {0x40, 0x0D, 0x01}, 0x7E4), std::nullopt);
    ask(0x7E5, {0x41, 0x13}, 0x7E4);
    ask(0x7E5, {0x42, 0x00, 0x00, 0x01}, 0x7E4);
    EXPECT_EQ(ask(0x7E5, {0x43, 0x91, 0xD5, 0x12}, 0x7E4), Octets8{0x44});
    EXPECT_EQ(ask(0x7E5, {0x13, 0, 3}, 0x7E4), Octets8{0x13});
    ask(0x7E5, {0x15, 10}, 0x7E4);
    m_plant.withEncoder(0, [](SimulatedNode &node) { EXPECT_EQ(node.rate(), 250'000); });
    EXPECT_FALSE(ask(0x605, {0x40, 0x00, 0x10}, 0x585));
}

} // namespace
} // namespace codewheel::canopen
