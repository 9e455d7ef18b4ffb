// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulator/turning_shaft.h"
#include "vocabulary/instant.h"

#include <array>
#include <optional>
#include <string>

namespace codewheel::canopen {

// What makers do otherwise, each met on real encoders.
struct NodeQuirks
{
    enum class Restore : std::uint8_t {
        afterReset, // the factory values are stored, and in force after a reset
        atOnce,     // they are in force, and lost without storing
    };

    Instant silenceWhileStoring{}; // neither hears nor says anything
    bool startsItself = false;     // operational after boot-up
    bool lssForgets = false;       // LSS "store" is answered as done; only 1010h stores node and rate
    bool lssOnlyWhenStopped = false;
    bool speedIsOff = false; // 6030h is 0 until 3010h:1 is 1; the speed is in 3011h as well
    bool hasFixedMapping = false;
    bool keepsIdentifiers = false; // stored ones stay those of the old node number
    bool keepsPreset = false;      // a preset is stored when it is written
    bool rangeIsHighest = false;   // 6002h is the highest position, not the count
    bool writesOnlyPreOperational = false;
    bool hasNodeObject = false; // 2000h is the node number, in force after storing and a reset
    bool hasSwitches = false;   // which decide about it: 2000h is refused
    Restore restore = Restore::afterReset;
    bool restoresSettings = false; // and with them node 1 at 125 kBd
};

// A simulated encoder as it is found on the bus.
struct CanopenEncoderPlan
{
    enum class Form : std::uint8_t { singleTurn, multiTurn, linear };

    std::optional<int> node{}; // empty: none yet, it is to be given one by LSS
    int rate = 125'000;        // Bd
    Form form = Form::multiTurn;
    std::uint32_t profile = 406;     // of CiA: that of encoders, or another one with the same objects
    int deviceClass = 2;             // of CiA 406: 1 or 2
    PhysicalResolution resolution{}; // of a linear one: there and back, a step being linearStep
    std::int64_t raw = 0;            // physical position, steps
    double revolutionsPerMinute = 0; // positive: clockwise
    std::uint16_t inhibitTime = 100; // of TPDO1 as delivered, 100 us
    std::uint16_t cyclicTimer = 0;   // of it, ms; 0: only on change
    std::uint16_t heartbeat = 0;     // as delivered, ms; 0: none
    std::string name = "SIM58-CO";   // 1008h
    std::array<std::uint32_t, 4> identity{0, 0, 0x10000, 0}; // 1018h: vendor, product, revision, serial
    std::uint32_t operatingTime = 0;                         // 0.1 h
    NodeQuirks quirks{};

    static constexpr std::int64_t linearStep = 5'000; // 0.001 um

    bool isLinear() const { return form == Form::linear; }
    // As object 1000h tells it.
    std::uint32_t deviceType() const
    {
        const std::uint32_t kind = form == Form::singleTurn ? 1 : form == Form::multiTurn ? 2 : 8;
        return kind << 16 | profile;
    }
    // Of the physical positions; the shaft of a linear one turns on where its rod comes back.
    std::int64_t positions() const { return isLinear() ? resolution.range() / 2 : resolution.range(); }
};

} // namespace codewheel::canopen
