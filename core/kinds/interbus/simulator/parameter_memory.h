// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/parameter_set.h"

#include <optional>

namespace codewheel {

// Error numbers, D28..D25 of IN (FRABA 10.3, Baumer 7).
namespace error_number {
inline constexpr unsigned wrongData = 1;
inline constexpr unsigned unknownNumber = 2;
inline constexpr unsigned parametersLost = 3;
inline constexpr unsigned notStored = 13;
inline constexpr unsigned batteryLow = 14;
inline constexpr unsigned codeDiscFaulty = 15;
} // namespace error_number

// What a simulated K3 encoder stores: the active set, the pending set that a handshake fills, and the EEPROM
// with its counted writes. In operation, pending and active are the same.
class ParameterMemory
{
public:
    ParameterMemory(ParameterSet factory, PhysicalResolution physical);

    const ParameterSet &active() const { return m_active; }
    int eepromWrites() const { return m_eepromWrites; }
    bool isLost() const { return m_lost; }
    bool isWornOut() const { return m_wornOut; }
    // Something was confirmed that run has not yet activated.
    bool hasPending() const { return m_written != 0 || m_toDefault; }
    bool isGoingToDefault() const { return m_toDefault; }

    // A confirmed parameter, 1..6 or 15: goes into the pending set, one write.
    void confirm(unsigned number, std::int64_t value);
    // A confirmed "set to default": the factory set becomes the pending one, one write.
    void confirmDefault();
    // A number that is in no manual was confirmed; the next run reports it.
    void confirmUnknown() { m_unknown = true; }

    // Run: activates and stores the pending set if it is consistent as a whole; otherwise returns the error
    // number, and the set stays pending.
    std::optional<unsigned> activate();

    enum class Storing : std::uint8_t { volatileOnly, inEeprom };
    // NPV as determined by the preset initialisation; disarms the preset. One write if it is stored.
    void setZeroOffset(std::int64_t value, Storing storing);

    void powerUp(); // loads what is stored, drops what is pending
    void lose();    // error 3, until default, or parameters 1-4, and run
    void setWornOut(bool wornOut) { m_wornOut = wornOut; } // run cannot store what is pending
    void countWrite() { ++m_eepromWrites; }

private:
    bool isRestored() const;

    ParameterSet m_factory;
    PhysicalResolution m_physical;
    ParameterSet m_active;
    ParameterSet m_pending;
    ParameterSet m_stored;
    unsigned m_written = 0; // bit n: parameter n is in the pending set
    bool m_toDefault = false;
    bool m_unknown = false;
    bool m_lost = false;
    bool m_wornOut = false;
    int m_eepromWrites = 0;
};

} // namespace codewheel
