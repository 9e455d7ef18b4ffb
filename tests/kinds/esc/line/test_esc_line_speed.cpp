// SPDX-License-Identifier: GPL-3.0-or-later
// The speed of a shaft whose encoder is one of three on a line, and is polled in turn.
#include "catalog/catalog.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include <cmath>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class EscLineSpeed : public testing::Test
{
protected:
    EscLineSpeed()
    {
        EXPECT_TRUE(link.open({}));
        runner.post(line_command::SetRunning{true});
        for (const EscLineAddress address :
             {EscLineAddress{0x05}, EscLineAddress{0x03}, EscLineAddress{0x12}})
            runner.post(line_command::AddDevice{
                std::make_unique<EscDriver>(*catalog.find(u"kuebler-esc-rs485"), address),
                QStringLiteral("encoder")});
    }

    void setSpeed(double rpm)
    {
        EXPECT_TRUE(line->withEncoder({0x05}, [&](SimulatedEscEncoder &one) { one.shaft().setSpeed(rpm); }));
    }
    // Tenths of a revolution per minute.
    std::optional<long> readAfter(Instant duration)
    {
        runner.turn(link.now() + duration);
        if (auto newest = runner.takeLatest())
            m_latest = std::move(newest);
        const auto speed = m_latest->devices.at(0).reading.stepsPerSecond;
        return speed ? std::optional(std::lround(*speed / 8192 * 600)) : std::nullopt;
    }

    const Catalog catalog = Catalog::builtIn();
    const std::shared_ptr<SimulatedEscLine> line = std::make_shared<SimulatedEscLine>();
    SimulatedEscLineLink link{line};
    EscLineRunner runner{link, {}, {}};

private:
    std::shared_ptr<const EscLineSnapshot> m_latest;
};

TEST_F(EscLineSpeed, WhatIsSetIsReadWhateverElseIsAsked)
{
    setSpeed(60);
    readAfter(3s);
    for (int frame = 0; frame < 300; ++frame) {
        const auto read = readAfter(33ms);
        ASSERT_TRUE(read);
        ASSERT_NEAR(static_cast<double>(*read), 600, 1) << frame;
    }
    setSpeed(-0.5);
    readAfter(5s);
    EXPECT_EQ(readAfter(33ms), -5);
}

TEST_F(EscLineSpeed, ASilentEncoderHasNone)
{
    setSpeed(60);
    readAfter(3s);
    EXPECT_TRUE(line->withEncoder({0x05}, [](SimulatedEscEncoder &one) { one.condition().mute = true; }));
    EXPECT_EQ(readAfter(5s), std::nullopt);
}

} // namespace
} // namespace codewheel
