// SPDX-License-Identifier: GPL-3.0-or-later
// The speed of a shaft on the training ring, on a machine too busy for every cycle.
#include "catalog/catalog.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/simulator/training_bus.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class RingSpeed : public testing::Test
{
protected:
    RingSpeed() { EXPECT_TRUE(training.link->open()); }

    // Positions and tenths of a revolution per minute, as the driver of the K2 at 4.0 reads them.
    std::set<std::optional<long>> turn(Instant duration, Instant longestGap)
    {
        std::set<std::optional<long>> readings;
        std::uniform_int_distribution<std::int64_t> gap(1, longestGap / 1ms);
        const Instant end = training.link->now() + duration;
        while (training.link->now() < end) {
            training.link->wait(training.link->now() + gap(m_random) * 1ms);
            std::array<Word, 7> in{};
            EXPECT_TRUE(training.link->exchange(std::array<Word, 7>{}, in));
            driver->cycle(in[3], 0, training.link->now());
            const auto speed = driver->reading().stepsPerSecond;
            readings.insert(speed ? std::optional(std::lround(*speed / 4096 * 600)) : std::nullopt);
        }
        return readings;
    }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training = makeTrainingBus(catalog);
    const std::unique_ptr<CyclicDriver> driver = makeDriver(*catalog.find(QStringLiteral("fraba-ocd-ib-k2")));

private:
    std::mt19937 m_random{4711};
};

TEST_F(RingSpeed, WhatIsSetIsReadThoughCyclesAreMissed)
{
    training.controls->setSpeed(NodeId("4.0"), 60);
    for (const Instant longestGap : {1ms, 3ms, 10ms}) {
        turn(700ms, longestGap);
        EXPECT_EQ(turn(5s, longestGap), std::set{std::optional(600L)}) << longestGap.count();
    }
}

TEST_F(RingSpeed, ShaftsTurnByTheClock)
{
    training.controls->setSpeed(NodeId("4.0"), 60);
    turn(1s, 1ms);
    const auto before = *driver->reading().position;
    const Instant begin = training.link->now();
    turn(10s, 20ms);
    const double seconds = std::chrono::duration<double>(training.link->now() - begin).count();
    EXPECT_NEAR(static_cast<double>(*driver->reading().position - before), seconds * 4096, 2);
}

} // namespace
} // namespace codewheel
