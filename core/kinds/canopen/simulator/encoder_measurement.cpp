// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/encoder_measurement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace codewheel::canopen {
namespace {

constexpr std::uint32_t countsCcw = 1U << 0; // 6000h
constexpr std::uint32_t isScaled = 1U << 2;
constexpr std::uint32_t measuresBackwards = 1U << 3;

std::int64_t within(std::int64_t value, std::int64_t range)
{
    const std::int64_t rest = value % range;
    return rest < 0 ? rest + range : rest;
}

// A low limit above the high one: the cam goes over the zero point (assumed).
bool isBetween(std::int64_t position, std::int64_t low, std::int64_t high)
{
    return low <= high ? position >= low && position <= high : position >= low || position <= high;
}

// b0 outside, b1 over, b2 under
std::uint8_t areaState(std::int64_t position, std::int64_t low, std::int64_t high)
{
    return position > high ? 0b011 : position < low ? 0b101 : 0;
}

} // namespace

EncoderMeasurement::EncoderMeasurement(const CanopenEncoderPlan &plan)
    : m_plan(plan)
    , m_shaft(plan.resolution, plan.raw)
{
    m_shaft.setSpeed(plan.revolutionsPerMinute);
}

bool EncoderMeasurement::isReversed(const ObjectDictionary &objects) const
{
    return (objects.word(0x6000) & (m_plan.isLinear() ? measuresBackwards : countsCcw)) != 0;
}

// Of the positions of a rotary encoder.
std::int64_t EncoderMeasurement::range(const ObjectDictionary &objects) const
{
    if ((objects.word(0x6000) & isScaled) == 0)
        return m_plan.positions();
    return objects.number(0x6002) + (m_plan.quirks.rangeIsHighest ? 1 : 0);
}

// Without the offset.
std::int64_t EncoderMeasurement::scaled(const ObjectDictionary &objects) const
{
    const std::int64_t positions = m_plan.positions();
    const std::int64_t raw = m_shaft.raw();
    const std::int64_t there = raw < positions ? raw : 2 * positions - 1 - raw; // or back
    const std::int64_t counted = isReversed(objects) ? positions - 1 - there : there;
    if (m_plan.isLinear()) {
        const std::int64_t step = objects.number(0x6005, 1);
        return step == 0 ? counted : counted * m_plan.linearStep / step;
    }
    const bool scales = (objects.word(0x6000) & isScaled) != 0;
    return scales ? counted * objects.number(0x6001) / m_plan.resolution.stepsPerTurn : counted;
}

std::int64_t EncoderMeasurement::position(const ObjectDictionary &objects) const
{
    const std::int64_t sum = scaled(objects) + objects.number(0x6509);
    return m_plan.isLinear() ? sum : within(sum, range(objects));
}

tl::expected<std::int64_t, AbortCode> EncoderMeasurement::offsetFor(std::int64_t position,
                                                                    const ObjectDictionary &objects) const
{
    if (m_plan.isLinear())
        return position - scaled(objects);
    if (position >= range(objects))
        return tl::unexpected(AbortCode::tooHigh);
    return position - within(scaled(objects), range(objects));
}

// Revolutions per minute, of a linear one as 6005h:2 says (x 0.01 mm/s). Both are assumed.
double EncoderMeasurement::speed(const ObjectDictionary &objects) const
{
    const double forward = isReversed(objects) ? -m_shaft.speed() : m_shaft.speed();
    if (!m_plan.isLinear())
        return forward;
    constexpr double stepsPerHundredthMillimetre = 10'000;
    const double perSecond = forward / 60 * m_plan.resolution.stepsPerTurn * m_plan.linearStep;
    const double sign = m_shaft.raw() < m_plan.positions() ? 1 : -1;
    return sign * perSecond / stepsPerHundredthMillimetre /
           static_cast<double>(std::max<std::int64_t>(1, objects.number(0x6005, 2)));
}

// What is on a cam leaves it by more than its hysteresis.
std::uint8_t EncoderMeasurement::cams(const ObjectDictionary &objects, std::int64_t position)
{
    const std::uint32_t enabled = objects.word(0x6301, 1);
    std::uint32_t states = 0;
    for (std::size_t cam = 0; cam < camCount; ++cam) {
        const std::uint32_t bit = 1U << cam;
        const auto value = [&](std::size_t index) {
            return objects.number(static_cast<std::uint16_t>(index + cam), 1);
        };
        const std::int64_t more = m_isOnCam[cam] ? value(0x6330) : 0;
        m_isOnCam[cam] =
            (enabled & bit) != 0 && isBetween(position, value(0x6310) - more, value(0x6320) + more);
        states |= m_isOnCam[cam] ? bit : 0;
    }
    return static_cast<std::uint8_t>((states ^ objects.word(0x6302, 1)) & enabled);
}

void EncoderMeasurement::refresh(ObjectDictionary &objects)
{
    constexpr double mostSpeed = std::numeric_limits<std::int16_t>::max();
    const std::int64_t now = position(objects);
    objects.set(0x6004, 0, now);
    objects.set(0x6500, 0, objects.number(0x6000));
    if (m_plan.deviceClass != 2)
        return;
    const auto speedNow = std::llround(std::clamp(speed(objects), -mostSpeed, mostSpeed));
    const bool isOff = m_plan.quirks.speedIsOff && objects.number(0x3010, 1) == 0;
    objects.set(0x6030, 1, isOff ? 0 : speedNow);
    objects.set(0x3011, 0, isOff ? 0 : speedNow);
    objects.set(0x6300, 1, cams(objects, now));
    objects.set(0x6400, 1, areaState(now, objects.number(0x6401, 1), objects.number(0x6402, 1)));
}

} // namespace codewheel::canopen
