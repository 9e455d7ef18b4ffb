// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_ring.h"

#include "kinds/interbus/ring/ring_refusals.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace codewheel {

void SimulatedRing::add(RingDevice participant, std::unique_ptr<SimulatedDevice> device)
{
    m_wiring.add(std::move(participant));
    m_present.push_back(device.get());
    m_devices.push_back(std::move(device));
    m_wrongDevices.emplace_back();
    m_lastOut.push_back(0);
    m_lastIn.push_back(0);
    m_master.powerUp();
}

RingStructure SimulatedRing::structure() const
{
    const std::scoped_lock lock(m_mutex);
    return m_master.configuration();
}

std::vector<Word> SimulatedRing::lastOut() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<Word> out;
    for (const std::size_t place : m_master.places())
        out.push_back(m_lastOut[place]);
    return out;
}

// The plan first, so that a fault occurs in the cycle it is due.
void SimulatedRing::passTime()
{
    if (m_plan.isRunning()) {
        m_plan.passCycle();
        while (m_plan.isRunning()) {
            const FaultStep *step = m_plan.due();
            if (step == nullptr)
                break;
            const auto place = std::ranges::find(m_wiring.planned(), step->place, &RingDevice::number);
            cause(step->fault, static_cast<std::size_t>(place - m_wiring.planned().begin()), step->value);
        }
    }
    m_master.cycle();
}

Result<void> SimulatedRing::exchange(std::span<const Word> out, std::span<Word> in)
{
    const std::scoped_lock lock(m_mutex);
    if (out.size() != m_master.places().size() || in.size() != out.size())
        return refuse(RefusalKind::link, RefusalId::linkFailed,
                      {QCoreApplication::translate(
                          "SimulatedRing", "The words do not match the devices of the training bus.")});
    passTime();
    if (!m_master.runs()) {
        idle();
        const MasterStatus &status = m_master.status();
        if (status.state != MasterState::busFail)
            return refuse(RefusalKind::link, RefusalId::notRunning);
        return refuse(RefusalKind::link, RingRefusalId::busFault,
                      {Word{status.errorCode}, Word{status.parameter}});
    }
    if (!m_master.isWhole() || m_wiring.hasCrcErrors())
        return exchangeSome(out, in);
    for (std::size_t i = 0; i < m_present.size(); ++i)
        in[i] = m_present[i]->cycle(out[i]);
    std::copy(out.begin(), out.end(), m_lastOut.begin());
    return {};
}

// The words of a faulty cycle are discarded at both ends: everything stays as it was.
Result<void> SimulatedRing::exchangeSome(std::span<const Word> out, std::span<Word> in)
{
    const bool isFaulty = m_master.isCycleFaulty();
    std::vector<std::size_t> words(m_wiring.size(), m_wiring.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        words[m_master.places()[i]] = i;
    m_lastIn.resize(out.size());
    for (std::size_t place = 0; place < m_devices.size(); ++place) {
        const std::size_t i = words[place];
        const bool takesPart = i < out.size() && m_master.takesPart(i);
        if (!isFaulty)
            m_lastOut[place] = takesPart ? out[i] : 0;
        const Word given = m_present[place]->cycle(m_lastOut[place]);
        if (i < out.size() && !isFaulty)
            m_lastIn[i] = takesPart ? given : 0;
    }
    std::ranges::copy(m_lastIn, in.begin());
    return {};
}

void SimulatedRing::missCycles(std::chrono::milliseconds time)
{
    const std::scoped_lock lock(m_mutex);
    for (SimulatedDevice *device : m_present)
        device->passTime(time);
}

void SimulatedRing::idleCycle()
{
    const std::scoped_lock lock(m_mutex);
    passTime();
    idle();
}

// Shafts keep turning, and the devices see the outputs they hold.
void SimulatedRing::idle()
{
    if (!m_master.holdsOutputs())
        std::ranges::fill(m_lastOut, Word{0});
    for (std::size_t place = 0; place < m_devices.size(); ++place)
        m_present[place]->cycle(m_lastOut[place]);
}

template <typename State>
std::vector<State> SimulatedRing::states(std::optional<State> (SimulatedDevice::*stateOf)() const) const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<State> states;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        if (auto state = ((*m_devices[i]).*stateOf)()) {
            state->number = m_wiring.planned()[i].number;
            states.push_back(*state);
        }
    }
    return states;
}

std::vector<SimulatedRing::Shaft> SimulatedRing::shafts() const
{
    return states(&SimulatedDevice::shaftState);
}

std::vector<SimulatedRing::Rod> SimulatedRing::rods() const
{
    return states(&SimulatedDevice::rodState);
}

template <typename Act, typename... Arguments>
void SimulatedRing::with(NodeId number, Act act, Arguments... arguments)
{
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < m_devices.size(); ++i)
        if (m_wiring.planned()[i].number == number)
            std::invoke(act, *m_devices[i], arguments...);
}

void SimulatedRing::turnTo(NodeId number, std::int64_t raw)
{
    with(number, &SimulatedDevice::turnTo, raw);
}

void SimulatedRing::powerCycle(NodeId number)
{
    with(number, &SimulatedDevice::powerCycle);
}

void SimulatedRing::turnBy(NodeId number, std::int64_t rawSteps)
{
    with(number, &SimulatedDevice::turnBy, rawSteps);
}

void SimulatedRing::setSpeed(NodeId number, double revolutionsPerMinute)
{
    with(number, &SimulatedDevice::setSpeed, revolutionsPerMinute);
}

void SimulatedRing::moveMagnetTo(NodeId number, double millimetres)
{
    with(number, &SimulatedDevice::moveMagnetTo, millimetres);
}

void SimulatedRing::setMagnetSpeed(NodeId number, double millimetresPerSecond)
{
    with(number, &SimulatedDevice::setMagnetSpeed, millimetresPerSecond);
}

} // namespace codewheel
