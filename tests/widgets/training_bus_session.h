// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

namespace codewheel::test {

inline constexpr Place fraba = "1.0"_ring;
inline constexpr Place baumer = "2.0"_ring;
inline constexpr Place singleTurn = "3.0"_ring; // K1
inline constexpr Place multiTurn = "4.0"_ring;  // K2
inline constexpr Place busTerminal = "6.0"_ring;
inline constexpr Place onLoop = "6.1"_ring;

// The training bus in virtual time, for tests of views.
class TrainingBusSession
{
public:
    explicit TrainingBusSession(RingSession::Start start = RingSession::Start::operating,
                                TrainingBus (*make)(const Catalog &) = makeTrainingBus)
        : training(make(catalog))
    {
        EXPECT_TRUE(bus.open(start));
        bus.advance(10);
        buses.add(bus);
    }

    WordChannel &channel(Place number) const { return *bus.channel(number); }
    EncoderSession &encoder(Place number) const { return *bus.encoder(number); }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training;
    std::shared_ptr<TrainingControls> controls = training.controls;
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    Buses buses;
};

} // namespace codewheel::test
