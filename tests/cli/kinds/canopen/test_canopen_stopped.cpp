// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl+C while something is done by hand.
#include "kinds/canopen/protocol/frames.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <csignal>
#include <deque>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

// Presses Ctrl+C when a frame with this identifier and these first octets passes, and notes those of LSS.
class Interrupter final : public CanParticipant
{
public:
    Interrupter(std::uint32_t identifier, std::vector<std::uint8_t> octets)
        : m_identifier(identifier)
        , m_octets(std::move(octets))
    {}

    int rate() const override { return 125'000; }
    const CanFrame *toSend() const override { return nullptr; }
    void sent(const CanFrame & /*frame*/, Instant /*now*/) override {}
    void take(const CanFrame &frame, Instant /*now*/) override
    {
        if (frame.id == 0x7E5)
            requests.push_back(frame.bytes[0] << 8 | frame.bytes[1]);
        const auto data = frame.data();
        if (frame.id == m_identifier && data.size() >= m_octets.size() &&
            std::ranges::equal(data.first(m_octets.size()), m_octets))
            std::raise(SIGINT);
    }

    std::vector<int> requests;

private:
    std::uint32_t m_identifier;
    std::vector<std::uint8_t> m_octets;
};

class CliCanStopped : public testing::Test
{
protected:
    CliRun stoppedAt(std::uint32_t identifier, std::vector<std::uint8_t> octets, const QString &line)
    {
        interrupter = std::make_shared<Interrupter>(identifier, std::move(octets));
        bus.plant().bus()->add(interrupter);
        CliRun run = bus.runLine(line);
        bus.plant().bus()->remove(*interrupter);
        return run;
    }

    SharedCanBus bus;
    std::shared_ptr<Interrupter> interrupter;
};

TEST_F(CliCanStopped, ASearchByLssIsLeft)
{
    const CliRun run = stoppedAt(0x7E5, {0x51, 0, 0, 0, 0, 20}, QStringLiteral("lss scan --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "cancelled");
    EXPECT_EQ(interrupter->requests.back(), 0x0400) << "back to waiting";
}

TEST_F(CliCanStopped, ASelectedDeviceIsLeftAndNothingWritten)
{
    const CliRun run = stoppedAt(0x7E5, {0x5E}, QStringLiteral("lss node 16 --of can:6 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "cancelled");
    EXPECT_EQ(std::ranges::count(interrupter->requests, 0x1110), 0);
    EXPECT_EQ(interrupter->requests.back(), 0x0400);
}

TEST_F(CliCanStopped, WhatWasSentByLssIsWaitedFor)
{
    const CliRun run = stoppedAt(0x7E5, {0x11}, QStringLiteral("lss node 16 --of can:6 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("has taken the number"));
    EXPECT_EQ(interrupter->requests.back(), 0x0400);
}

TEST_F(CliCanStopped, NoObjectIsWrittenAfterIt)
{
    const CliRun run = stoppedAt(0x606, {0x40, 0x01, 0x60}, QStringLiteral("od can:6 write 6001=4096 --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:6 read 6001")).out, HasSubstr("8192"));
}

TEST_F(CliCanStopped, AnObjectThatWasWrittenIsReadBack)
{
    const CliRun run = stoppedAt(0x606, {0x23, 0x01, 0x60}, QStringLiteral("od can:6 write 6001=4096 --yes"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Written, and read back."));
}

TEST_F(CliCanStopped, AStateThatIsNotSeenAnyMoreIsNotKnown)
{
    const CliRun run = stoppedAt(0x000, {0x02}, QStringLiteral("nmt stop can:5 --yes --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "nmtStateNotKnown");
}

} // namespace
} // namespace codewheel
