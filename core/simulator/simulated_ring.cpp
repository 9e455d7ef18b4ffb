// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/simulated_ring.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace codewheel {

static_assert(TrainingControls::fastest == TurningShaft::fastest);

void SimulatedRing::add(Participant participant, std::unique_ptr<SimulatedK3> encoder)
{
    m_structure.push_back(std::move(participant));
    m_encoders.push_back(std::move(encoder));
    m_lastOut.push_back(0);
}

std::vector<Word> SimulatedRing::lastOut() const
{
    const std::scoped_lock lock(m_mutex);
    return m_lastOut;
}

void SimulatedRing::exchange(std::span<const Word> out, std::span<Word> in)
{
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < m_encoders.size(); ++i)
        in[i] = m_encoders[i]->cycle(out[i]);
    std::copy(out.begin(), out.end(), m_lastOut.begin());
}

std::vector<TrainingControls::Shaft> SimulatedRing::shafts() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<Shaft> shafts;
    shafts.reserve(m_encoders.size());
    for (std::size_t i = 0; i < m_encoders.size(); ++i) {
        const SimulatedK3 &encoder = *m_encoders[i];
        const TurningShaft &shaft = encoder.shaft();
        shafts.push_back({.number = m_structure[i].number,
                          .raw = shaft.raw(),
                          .stepsPerTurn = shaft.resolution().stepsPerTurn,
                          .turns = shaft.resolution().turns,
                          .revolutionsPerMinute = shaft.speed(),
                          .powered = encoder.isPowered(),
                          .slow = encoder.isSlow(),
                          .hasBattery = encoder.hasBattery(),
                          .batteryLow = encoder.isBatteryLow(),
                          .eepromWrites = encoder.eepromWrites()});
    }
    return shafts;
}

// A place that is not in the ring is passed over.
template <typename Act>
void SimulatedRing::with(DeviceNumber number, Act act)
{
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < m_encoders.size(); ++i) {
        if (m_structure[i].number == number)
            act(*m_encoders[i]);
    }
}

void SimulatedRing::turnTo(DeviceNumber number, std::int64_t raw)
{
    with(number, [raw](SimulatedK3 &encoder) { encoder.turnTo(raw); });
}

void SimulatedRing::turnBy(DeviceNumber number, std::int64_t rawSteps)
{
    with(number, [rawSteps](SimulatedK3 &encoder) { encoder.turnBy(rawSteps); });
}

void SimulatedRing::setSpeed(DeviceNumber number, double revolutionsPerMinute)
{
    with(number, [revolutionsPerMinute](SimulatedK3 &encoder) { encoder.setSpeed(revolutionsPerMinute); });
}

void SimulatedRing::setPower(DeviceNumber number, bool on)
{
    with(number, [on](SimulatedK3 &encoder) { encoder.setPower(on); });
}

void SimulatedRing::powerCycle(DeviceNumber number)
{
    with(number, [](SimulatedK3 &encoder) { encoder.powerCycle(); });
}

void SimulatedRing::setSlow(DeviceNumber number, bool slow)
{
    with(number, [slow](SimulatedK3 &encoder) { encoder.setSlow(slow); });
}

void SimulatedRing::loseParameters(DeviceNumber number)
{
    with(number, [](SimulatedK3 &encoder) { encoder.loseParameters(); });
}

void SimulatedRing::setBatteryLow(DeviceNumber number, bool low)
{
    with(number, [low](SimulatedK3 &encoder) { encoder.setBatteryLow(low); });
}

namespace {
tl::unexpected<Refusal> linkFailed(const char *text)
{
    return refuse(RefusalKind::link, RefusalId::linkFailed,
                  {QCoreApplication::translate("SimulatedRing", text)});
}
} // namespace

SimulatedRingLink::SimulatedRingLink(std::shared_ptr<SimulatedRing> ring)
    : m_ring(std::move(ring))
    , m_devices(m_ring->structure().size())
{}

Result<RingStructure> SimulatedRingLink::open()
{
    m_open = true;
    return m_ring->structure();
}

void SimulatedRingLink::close()
{
    m_open = false;
}

Result<std::vector<Word>> SimulatedRingLink::readBackOut()
{
    if (!m_open)
        return linkFailed(QT_TRANSLATE_NOOP("SimulatedRing", "The training bus is not connected."));
    return m_ring->lastOut();
}

Result<void> SimulatedRingLink::exchange(std::span<const Word> out, std::span<Word> in)
{
    if (!m_open)
        return linkFailed(QT_TRANSLATE_NOOP("SimulatedRing", "The training bus is not connected."));
    if (out.size() != m_devices || in.size() != m_devices)
        return linkFailed(
            QT_TRANSLATE_NOOP("SimulatedRing", "The words do not match the devices of the training bus."));
    m_ring->exchange(out, in);
    return {};
}

} // namespace codewheel
