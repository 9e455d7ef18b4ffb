// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_position_encoder.h"

namespace codewheel {

SimulatedPositionEncoder::SimulatedPositionEncoder(PhysicalResolution resolution, std::int64_t raw)
    : m_shaft(resolution, raw)
{
    refresh();
}

Word SimulatedPositionEncoder::cycle(Word)
{
    const Word in = m_in;
    m_shaft.advance();
    if (m_offFor > 0 && --m_offFor == 0)
        m_powered = true;
    refresh();
    return in;
}

void SimulatedPositionEncoder::passTime(std::chrono::milliseconds time)
{
    m_shaft.advance(time);
    refresh();
}

void SimulatedPositionEncoder::refresh()
{
    m_in = m_powered ? static_cast<Word>(m_shaft.raw()) : 0;
}

std::optional<TrainingControls::Shaft> SimulatedPositionEncoder::shaftState() const
{
    TrainingControls::Shaft state = TrainingControls::of(m_shaft);
    state.powered = m_powered;
    state.hasParameters = false;
    return state;
}

void SimulatedPositionEncoder::turnTo(std::int64_t raw)
{
    m_shaft.turnTo(raw);
    refresh();
}

void SimulatedPositionEncoder::turnBy(std::int64_t rawSteps)
{
    m_shaft.turnBy(rawSteps);
    refresh();
}

void SimulatedPositionEncoder::setSpeed(double revolutionsPerMinute)
{
    m_shaft.setSpeed(revolutionsPerMinute);
}

void SimulatedPositionEncoder::setPower(bool on)
{
    m_powered = on;
    m_offFor = 0;
    refresh();
}

void SimulatedPositionEncoder::powerCycle()
{
    setPower(false);
    m_offFor = powerCycleCycles;
}

} // namespace codewheel
