// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_k3.h"

#include "kinds/interbus/words/k3_word.h"

namespace codewheel {

SimulatedK3::SimulatedK3(TurningShaft shaft, ParameterSet factory, EncoderTiming timing)
    : m_shaft(shaft)
    , m_memory(factory, shaft.resolution())
    , m_arithmetic(factory, shaft.resolution())
    , m_timing(timing)
{}

Word SimulatedK3::cycle(Word out)
{
    const Word in = m_in;
    m_shaft.advance();
    if (m_phase == Phase::off)
        passOffTime();
    else if (m_phase != Phase::operation || !m_watch.isOld(out))
        see(out);
    refresh();
    return in;
}

void SimulatedK3::passTime(std::chrono::milliseconds time)
{
    m_shaft.advance(time);
    refresh();
}

std::optional<TrainingControls::Shaft> SimulatedK3::shaftState() const
{
    TrainingControls::Shaft state = TrainingControls::of(m_shaft);
    state.powered = isPowered();
    state.slow = m_slow;
    state.hasBattery = hasBattery();
    state.batteryLow = isBatteryLow();
    state.reportsFaults = reportsFaults();
    state.eepromWornOut = m_memory.isWornOut();
    state.codeDiscFaulty = isCodeDiscFaulty();
    state.hasCams = hasCams();
    state.camOutOfRange = isCamOutOfRange();
    state.eepromWrites = eepromWrites();
    return state;
}

bool SimulatedK3::showsOperation() const
{
    return m_phase == Phase::operation || (m_phase == Phase::processing && m_shown == 0);
}

void SimulatedK3::enter(Phase phase, Word shown)
{
    m_phase = phase;
    m_shown = shown;
}

void SimulatedK3::see(Word out)
{
    m_watch.see(out);
    if (m_phase == Phase::startingUp) {
        if (--m_remaining <= 0)
            finishStartUp();
        return;
    }
    seen(out);
    if (m_watch.startEdge() && m_phase != Phase::operation)
        m_runIn = m_timing.runAfter;
    if (m_phase == Phase::processing) {
        if (--m_remaining <= 0)
            finishProcessing();
        runWhenDue();
        return; // the next word in the next cycle: a refusal shows for at least one cycle
    }
    runWhenDue();
    if (!m_watch.isDone() && m_watch.hasStood(m_timing.takenAfter)) {
        const bool started = (out & k3::startBit) != 0; // everything else is ignored
        if (started || take(out))
            m_watch.setDone();
    }
}

void SimulatedK3::process(Word out, Word meanwhile)
{
    m_processed = out;
    m_remaining = m_timing.processing * (m_slow ? slowFactor : 1);
    enter(Phase::processing, meanwhile);
}

void SimulatedK3::finishProcessing()
{
    const Word answer = answerTo(m_processed);
    if (k3::isConfirmation(answer)) {
        acknowledge(answer);
    } else {
        m_runIn = noRun; // a run seen meanwhile must not hide the refusal
        failWith(answer);
    }
}

Word SimulatedK3::answerTo(Word processed)
{
    if (confirm(k3::number(processed), k3::data(processed)))
        return k3::confirmation | processed;
    return k3::error | k3::withNumber(error_number::wrongData);
}

void SimulatedK3::runWhenDue()
{
    if (m_runIn > 0)
        --m_runIn;
    if (m_runIn == 0 && m_phase != Phase::processing) {
        m_runIn = noRun;
        run();
    }
}

void SimulatedK3::run()
{
    if (const auto standing = fault()) {
        failWith(*standing);
        return;
    }
    const bool toDefault = m_memory.isGoingToDefault();
    if (const auto error = m_memory.activate()) {
        fail(*error);
        return;
    }
    if (toDefault)
        wentToDefault();
    m_arithmetic = EncoderArithmetic(m_memory.active(), m_shaft.resolution());
    operate();
}

void SimulatedK3::fail(unsigned errorNumber)
{
    failWith(k3::error | k3::withNumber(errorNumber));
}

void SimulatedK3::initialisePreset(ParameterMemory::Storing storing)
{
    m_memory.setZeroOffset(m_arithmetic.zeroOffsetForPreset(m_shaft.raw()), storing);
    m_arithmetic = EncoderArithmetic(m_memory.active(), m_shaft.resolution());
}

void SimulatedK3::setPower(bool on)
{
    if (on && m_phase == Phase::off) {
        switchOn();
    } else if (!on) {
        m_remaining = 0;
        m_runIn = noRun;
        m_readOut = 0;
        enter(Phase::off, 0);
    }
    refresh();
}

void SimulatedK3::powerCycle()
{
    setPower(false);
    m_remaining = powerCycleCycles;
}

void SimulatedK3::passOffTime()
{
    if (m_remaining > 0 && --m_remaining == 0)
        switchOn();
}

void SimulatedK3::switchOn()
{
    m_memory.powerUp();
    m_watch.reset();
    m_arithmetic = EncoderArithmetic(m_memory.active(), m_shaft.resolution());
    poweredUp();
    m_remaining = m_timing.startUp;
    enter(Phase::startingUp, k3::confirmation);
    if (m_remaining <= 0)
        finishStartUp();
}

void SimulatedK3::finishStartUp()
{
    if (const auto standing = fault())
        failWith(*standing);
    else if (const auto error = startUpError())
        fail(*error);
    else if (m_memory.isLost())
        fail(error_number::parametersLost);
    else
        operate();
}

void SimulatedK3::loseParameters()
{
    m_memory.lose();
    wentToDefault();
    m_arithmetic = EncoderArithmetic(m_memory.active(), m_shaft.resolution());
    m_runIn = noRun;
    if (m_phase != Phase::off && m_phase != Phase::startingUp)
        fail(error_number::parametersLost);
    refresh();
}

// Once the cause is gone, run leaves the error.
void SimulatedK3::faultChanged()
{
    const auto standing = fault();
    if (standing && m_phase != Phase::off && m_phase != Phase::startingUp) {
        m_runIn = noRun;
        failWith(*standing);
    }
    refresh();
}

void SimulatedK3::turnTo(std::int64_t raw)
{
    m_shaft.turnTo(raw);
    refresh();
}

void SimulatedK3::turnBy(std::int64_t rawSteps)
{
    m_shaft.turnBy(rawSteps);
    refresh();
}

void SimulatedK3::setSpeed(double rpm)
{
    m_shaft.setSpeed(rpm);
    refresh();
}

} // namespace codewheel
