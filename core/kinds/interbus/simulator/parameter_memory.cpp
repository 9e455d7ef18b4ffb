// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/parameter_memory.h"

namespace codewheel {

namespace {

constexpr unsigned bitOf(unsigned number)
{
    return 1U << number;
}

std::int64_t &valueIn(ParameterSet &set, unsigned number)
{
    switch (number) {
    case parameter_number::steps:
        return set.steps;
    case parameter_number::revolutions:
        return set.revolutions;
    case parameter_number::coding:
        return set.coding;
    case parameter_number::preset:
        return set.preset;
    case parameter_number::zeroOffset:
        return set.zeroOffset;
    case parameter_number::offset:
        return set.offset;
    default:
        return set.measuringRange;
    }
}

} // namespace

ParameterMemory::ParameterMemory(ParameterSet factory, PhysicalResolution physical)
    : m_factory(factory)
    , m_physical(physical)
    , m_active(factory)
    , m_pending(factory)
    , m_stored(factory)
{}

void ParameterMemory::confirm(unsigned number, std::int64_t value)
{
    valueIn(m_pending, number) = value;
    if (number == parameter_number::preset)
        m_pending.presetArmed = true;
    m_written |= bitOf(number);
    countWrite();
}

void ParameterMemory::confirmDefault()
{
    m_pending = m_factory;
    m_written = 0;
    m_toDefault = true;
    countWrite();
}

bool ParameterMemory::isRestored() const
{
    using namespace parameter_number;
    constexpr unsigned needed = bitOf(steps) | bitOf(revolutions) | bitOf(coding) | bitOf(preset);
    return m_toDefault || (m_written & needed) == needed;
}

std::optional<unsigned> ParameterMemory::activate()
{
    if (m_unknown) {
        m_unknown = false; // there is no value that could be corrected
        return error_number::unknownNumber;
    }
    if (m_lost && !isRestored())
        return error_number::parametersLost;
    if (!isAdmissible(m_pending, m_physical))
        return error_number::wrongData;
    const std::int64_t total = totalRange(m_pending);
    const bool zeroOffsetWritten = (m_written & bitOf(parameter_number::zeroOffset)) != 0;
    if (zeroOffsetWritten && m_pending.zeroOffset >= total)
        return error_number::wrongData;
    if (m_wornOut && hasPending())
        return error_number::notStored;

    m_pending.zeroOffset %= total;
    m_active = m_pending;
    if (hasPending())
        m_stored = m_active;
    m_written = 0;
    m_toDefault = false;
    m_lost = false;
    return std::nullopt;
}

void ParameterMemory::setZeroOffset(std::int64_t value, Storing storing)
{
    m_active.zeroOffset = value;
    m_active.presetArmed = false;
    m_pending = m_active;
    if (storing == Storing::inEeprom) {
        m_stored = m_active;
        countWrite();
    }
}

void ParameterMemory::powerUp()
{
    m_active = m_stored;
    m_pending = m_stored;
    m_written = 0;
    m_toDefault = false;
    m_unknown = false;
}

void ParameterMemory::lose()
{
    m_stored = m_factory;
    powerUp();
    m_lost = true;
}

} // namespace codewheel
