// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/simulated_ring.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace codewheel {

void SimulatedRing::add(Participant participant, std::unique_ptr<SimulatedDevice> device)
{
    m_structure.push_back(std::move(participant));
    m_devices.push_back(std::move(device));
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
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        in[i] = m_devices[i]->cycle(out[i]);
    std::copy(out.begin(), out.end(), m_lastOut.begin());
}

template <typename State>
std::vector<State> SimulatedRing::states(std::optional<State> (SimulatedDevice::*stateOf)() const) const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<State> states;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        if (auto state = ((*m_devices[i]).*stateOf)()) {
            state->number = m_structure[i].number;
            states.push_back(*state);
        }
    }
    return states;
}

std::vector<TrainingControls::Shaft> SimulatedRing::shafts() const
{
    return states(&SimulatedDevice::shaftState);
}

std::vector<TrainingControls::Rod> SimulatedRing::rods() const
{
    return states(&SimulatedDevice::rodState);
}

template <typename Act>
void SimulatedRing::with(DeviceNumber number, Act act)
{
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        if (m_structure[i].number == number)
            act(*m_devices[i]);
    }
}

void SimulatedRing::turnTo(DeviceNumber number, std::int64_t raw)
{
    with(number, [raw](SimulatedDevice &device) { device.turnTo(raw); });
}

void SimulatedRing::turnBy(DeviceNumber number, std::int64_t rawSteps)
{
    with(number, [rawSteps](SimulatedDevice &device) { device.turnBy(rawSteps); });
}

void SimulatedRing::setSpeed(DeviceNumber number, double revolutionsPerMinute)
{
    with(number, [revolutionsPerMinute](SimulatedDevice &device) { device.setSpeed(revolutionsPerMinute); });
}

void SimulatedRing::moveMagnetTo(DeviceNumber number, double millimetres)
{
    with(number, [millimetres](SimulatedDevice &device) { device.moveMagnetTo(millimetres); });
}

void SimulatedRing::setMagnetSpeed(DeviceNumber number, double millimetresPerSecond)
{
    with(number,
         [millimetresPerSecond](SimulatedDevice &device) { device.setMagnetSpeed(millimetresPerSecond); });
}

void SimulatedRing::setMagnetInRange(DeviceNumber number, bool inRange)
{
    with(number, [inRange](SimulatedDevice &device) { device.setMagnetInRange(inRange); });
}

void SimulatedRing::setPower(DeviceNumber number, bool on)
{
    with(number, [on](SimulatedDevice &device) { device.setPower(on); });
}

void SimulatedRing::powerCycle(DeviceNumber number)
{
    with(number, [](SimulatedDevice &device) { device.powerCycle(); });
}

void SimulatedRing::setSlow(DeviceNumber number, bool slow)
{
    with(number, [slow](SimulatedDevice &device) { device.setSlow(slow); });
}

void SimulatedRing::loseParameters(DeviceNumber number)
{
    with(number, [](SimulatedDevice &device) { device.loseParameters(); });
}

void SimulatedRing::setBatteryLow(DeviceNumber number, bool low)
{
    with(number, [low](SimulatedDevice &device) { device.setBatteryLow(low); });
}

void SimulatedRing::setEepromWornOut(DeviceNumber number, bool wornOut)
{
    with(number, [wornOut](SimulatedDevice &device) { device.setEepromWornOut(wornOut); });
}

void SimulatedRing::setCodeDiscFaulty(DeviceNumber number, bool faulty)
{
    with(number, [faulty](SimulatedDevice &device) { device.setCodeDiscFaulty(faulty); });
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
