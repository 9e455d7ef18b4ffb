// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_la66.h"

namespace codewheel {
namespace {

constexpr Word serviceBit = 0x8000'0000;
constexpr Word writeBit = 0x4000'0000;
constexpr Word errorBit = 0x2000'0000;
constexpr Word alwaysZero = 0x3000'0000; // D29 and D28 of OUT
constexpr Word dataMask = 0x00FF'FFFF;
constexpr Word controlMask = 0xFF00'0000;
constexpr Word magnetOutside = 0x20; // bit 5 of the error status

// D27..D24
enum Service : unsigned {
    countingDirection = 1,
    measuringLength = 2,
    externalPreset = 4,
    presetAdjustment = 6,
    errorStatus = 8
};

unsigned serviceOf(Word out)
{
    return out >> 24 & 0xF;
}

bool canBeRead(unsigned service)
{
    return service == countingDirection || service == measuringLength || service == externalPreset ||
           service == errorStatus;
}

} // namespace

SimulatedLa66::SimulatedLa66(double lengthMillimetres, int processing)
    : m_magnet(lengthMillimetres)
    , m_processing(processing)
{
    look();
    refresh();
}

Word SimulatedLa66::cycle(Word out)
{
    const Word in = m_in;
    m_magnet.advance();
    if (m_phase == Phase::off) {
        passOffTime();
    } else {
        look();
        see(out);
    }
    refresh();
    return in;
}

void SimulatedLa66::passTime(std::chrono::milliseconds time)
{
    m_magnet.advance(time);
    if (m_phase != Phase::off)
        look();
    refresh();
}

std::optional<TrainingControls::Rod> SimulatedLa66::rodState() const
{
    return TrainingControls::Rod{.number = {},
                                 .millimetres = m_magnet.millimetres(),
                                 .lengthMillimetres = m_magnet.lengthInMillimetres(),
                                 .millimetresPerSecond = m_magnet.speed(),
                                 .magnetInRange = m_magnetInRange,
                                 .powered = m_phase != Phase::off,
                                 .slow = m_slow,
                                 .eepromWrites = m_eepromWrites};
}

void SimulatedLa66::look()
{
    if (m_magnetInRange)
        m_seenAt = m_magnet.nanometres();
    else
        m_error = true;
}

void SimulatedLa66::refresh()
{
    if (m_phase == Phase::off)
        m_in = 0;
    else if (m_phase == Phase::answered)
        m_in = m_answer;
    else
        m_in = (m_error ? errorBit : 0) | position();
}

// The encoder acts on 0 -> 1 of the service bit, and ignores the rest of OUT until the bit is 0 again.
void SimulatedLa66::see(Word out)
{
    const bool asked = (out & serviceBit) != 0;
    if (m_phase == Phase::answered && !asked)
        m_phase = Phase::normal;
    if (m_phase == Phase::normal && asked && !m_serviceBit) {
        m_phase = Phase::processing;
        m_request = out;
        m_remaining = m_processing * (m_slow ? slowFactor : 1);
    }
    m_serviceBit = asked;
    if (m_phase == Phase::processing && --m_remaining <= 0) {
        m_answer = answerTo(m_request);
        m_phase = Phase::answered;
    }
}

// What is refused comes back with D29 = 1 and changes nothing (assumed).
Word SimulatedLa66::answerTo(Word out)
{
    const bool writes = (out & writeBit) != 0;
    const bool isKnown = (out & alwaysZero) == 0 && (writes || canBeRead(serviceOf(out)));
    if (!isKnown || (writes && !write(out)))
        return out | errorBit;
    return writes ? out : (out & controlMask) | read(serviceOf(out));
}

bool SimulatedLa66::write(Word out)
{
    const Word data = out & dataMask;
    switch (serviceOf(out)) {
    case countingDirection:
        if (data > 1)
            return false;
        m_parameters.direction = data;
        break;
    case measuringLength:
        if (data == 0)
            return false;
        m_parameters.measuringLength = data;
        break;
    case externalPreset:
        m_parameters.externalPreset = data;
        break;
    case presetAdjustment:
        m_parameters.offset = (data - counted()) & dataMask;
        break;
    default:
        return false;
    }
    ++m_eepromWrites;
    return true;
}

Word SimulatedLa66::read(unsigned service)
{
    switch (service) {
    case countingDirection:
        return m_parameters.direction;
    case measuringLength:
        return m_parameters.measuringLength;
    case externalPreset:
        return m_parameters.externalPreset;
    default:
        return readErrorStatus();
    }
}

// Reading it clears the error bit once the magnet is back (assumed).
Word SimulatedLa66::readErrorStatus()
{
    const Word status = m_error ? magnetOutside : 0;
    m_error = !m_magnetInRange;
    return status;
}

// Steps from the head of the rod, or from its end if it counts down (assumed: length - p). Before the preset
// adjustment.
Word SimulatedLa66::counted() const
{
    const auto steps = std::int64_t{m_parameters.measuringLength};
    const auto fromHead = static_cast<Word>(m_seenAt * steps / m_magnet.lengthInNanometres());
    return m_parameters.direction == 0 ? fromHead : m_parameters.measuringLength - fromHead;
}

Word SimulatedLa66::position() const
{
    return (counted() + m_parameters.offset) & dataMask;
}

void SimulatedLa66::moveMagnetTo(double millimetres)
{
    m_magnet.moveTo(millimetres);
    if (m_phase != Phase::off)
        look();
    refresh();
}

void SimulatedLa66::setPower(bool on)
{
    if (on && m_phase == Phase::off) {
        switchOn();
    } else if (!on) {
        m_remaining = 0;
        m_phase = Phase::off;
    }
    refresh();
}

void SimulatedLa66::powerCycle()
{
    setPower(false);
    m_remaining = powerCycleCycles;
}

void SimulatedLa66::passOffTime()
{
    if (m_remaining > 0 && --m_remaining == 0)
        switchOn();
}

// Without its magnet it knows no position: 0 (assumed).
void SimulatedLa66::switchOn()
{
    m_phase = Phase::normal;
    m_serviceBit = true;
    m_error = false;
    m_seenAt = 0;
    look();
}

} // namespace codewheel
