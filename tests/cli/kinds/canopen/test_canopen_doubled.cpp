// SPDX-License-Identifier: GPL-3.0-or-later
// Two devices with one number: whatever addresses it says so.
#include "kinds/canopen/protocol/frames.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <deque>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

// Another one with the number 6: answers each SDO request with 77, and boots when it is told to.
class Twin final : public CanParticipant
{
public:
    int rate() const override { return 125'000; }
    const CanFrame *toSend() const override { return m_frames.empty() ? nullptr : &m_frames.front(); }
    void sent(const CanFrame & /*frame*/, Instant /*now*/) override { m_frames.pop_front(); }
    void take(const CanFrame &frame, Instant /*now*/) override
    {
        using Octets = std::vector<std::uint8_t>;
        if (frame.id == 0x606 && frame.bytes[0] == 0x40)
            m_frames.push_back(canopen::frameOf(
                0x586, Octets{0x43, frame.bytes[1], frame.bytes[2], frame.bytes[3], 77, 0, 0, 0}));
        else if (frame.id == 0x606)
            m_frames.push_back(canopen::frameOf(
                0x586, Octets{0x60, frame.bytes[1], frame.bytes[2], frame.bytes[3], 0, 0, 0, 0}));
        if (frame.id == 0x606 && frame.bytes[0] != 0x40)
            ++writes;
        if (frame.id == 0 && frame.bytes[0] == 0x81)
            m_frames.push_back(canopen::frameOf(0x706, Octets{0}));
    }

    int writes = 0;

private:
    std::deque<CanFrame> m_frames;
};

// Answers by LSS what is asked, after the other one, as another device.
class LssTwin final : public CanParticipant
{
public:
    int rate() const override { return 125'000; }
    const CanFrame *toSend() const override { return m_frames.empty() ? nullptr : &m_frames.front(); }
    void sent(const CanFrame & /*frame*/, Instant /*now*/) override { m_frames.pop_front(); }
    void take(const CanFrame &frame, Instant /*now*/) override
    {
        if (frame.id == 0x7E5 && frame.bytes[0] == 0x11)
            ++numbers;
        if (frame.id != 0x7E4 || frame.bytes[0] < 0x5A || frame.bytes[0] > 0x5E)
            return;
        CanFrame own = frame;
        own.bytes[1] = static_cast<std::uint8_t>(own.bytes[1] + 1);
        m_frames.push_back(own);
    }

    int numbers = 0;

private:
    std::deque<CanFrame> m_frames;
};

TEST(CliLssOfSeveral, NothingIsWritten)
{
    SharedCanBus bus({canopen::trainingEncoders()[1]});
    const auto twin = std::make_shared<LssTwin>();
    bus.plant().bus()->add(twin);
    const CliRun run = bus.runLine(QStringLiteral("lss node 9 --alone --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "lssSeveral");
    EXPECT_EQ(twin->numbers, 0);
}

class CliCanDoubled : public testing::Test
{
protected:
    CliCanDoubled() { bus.plant().bus()->add(twin); }

    SharedCanBus bus;
    std::shared_ptr<Twin> twin = std::make_shared<Twin>();
};

TEST_F(CliCanDoubled, IsSaidAndNothingWritten)
{
    for (const char *line :
         {"od can:6 read 6001", "od can:6 write 6001=4096 --yes", "read can:6 steps",
          "read can:6 steps --device canopen-406-multi-turn", "write can:6 steps=4096 --yes",
          "preset can:6 1000", "reset can:6 --yes", "lss show --of can:6", "lss node 16 --of can:6 --yes"}) {
        const CliRun run = bus.runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 1) << line;
        EXPECT_EQ(errorKey(run), "canopenNodeNumberDoubled") << line << '\n' << run.out;
    }
    EXPECT_EQ(twin->writes, 0);
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:5 read 6004")).exit, 0);
}

TEST_F(CliCanDoubled, IsSaidAfterAResetToo)
{
    const CliRun run = bus.runLine(QStringLiteral("nmt reset can:6 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "canopenNodeNumberDoubled");
}

} // namespace
} // namespace codewheel
