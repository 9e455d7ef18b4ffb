// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "recording/recorded_device.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(RecordedDevice, HasWhatIsKnownOfAnEncoder)
{
    const Catalog catalog = Catalog::builtIn();
    RingSession ring(makeTrainingBus(catalog).link, catalog, QDateTime::currentDateTime());
    ASSERT_TRUE(ring.open(EncoderBus::Start::watching));
    ring.advance(std::chrono::milliseconds(10));
    EncoderSession &encoder = *ring.encoder("1.0"_ring);
    encoder.tell(Parameter::steps, 8'192);
    const RecordedDevice device = recordedDevice(encoder);
    EXPECT_TRUE(catalog.find(device.key));
    EXPECT_FALSE(device.name.isEmpty());
    EXPECT_GT(device.stepsPerTurn, 0);
    EXPECT_EQ(valueOf(device.known, Parameter::steps), 8'192);
    EXPECT_EQ(recordedDeviceFromJson(toJson(device)), device);
}

TEST(RecordedDevice, WhatIsNotUnderstoodIsLeftOut)
{
    EXPECT_EQ(recordedDeviceFromJson("nonsense"), RecordedDevice());
    const RecordedDevice device = recordedDeviceFromJson(
        R"({"device": 5, "name": "X", "turns": -3, "parameters": {"steps": [], "preset": 7, "later": 1}})");
    EXPECT_EQ(device, (RecordedDevice{.name = QStringLiteral("X"), .known = {{Parameter::preset, 7}}}));
}

} // namespace
} // namespace codewheel
