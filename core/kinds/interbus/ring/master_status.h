// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/bus_fault.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace codewheel {

// Master states (IBS SYS FW G4): READY, ACTIVE (ID cycles), RUN (data cycles), BUS FAIL.
enum class MasterState : std::uint8_t { ready, active, run, busFail };

// The diagnostic status register of a G4 master, bits 0..15. Healthy in RUN: 00E0h.
namespace diagnostic {
inline constexpr std::uint16_t user = 1U << 0;
inline constexpr std::uint16_t peripheralFault = 1U << 1; // PF
inline constexpr std::uint16_t bus = 1U << 2;
inline constexpr std::uint16_t controller = 1U << 3; // CTRL
inline constexpr std::uint16_t detect = 1U << 4;     // looking for the fault
inline constexpr std::uint16_t run = 1U << 5;
inline constexpr std::uint16_t active = 1U << 6;
inline constexpr std::uint16_t ready = 1U << 7;
inline constexpr std::uint16_t bsa = 1U << 8; // a segment is switched off
inline constexpr std::uint16_t systemFail = 1U << 9;
inline constexpr std::uint16_t result = 1U << 10;
inline constexpr std::uint16_t syResult = 1U << 11;
inline constexpr std::uint16_t dcResult = 1U << 12;
inline constexpr std::uint16_t warning = 1U << 13;
inline constexpr std::uint16_t quality = 1U << 14;
inline constexpr std::uint16_t sdsi = 1U << 15;
} // namespace diagnostic

// As a master shows it that has no fault to name, where the link reaches none.
constexpr std::uint16_t registerOf(MasterState state) noexcept
{
    switch (state) {
    case MasterState::ready:
        return diagnostic::ready;
    case MasterState::active:
        return diagnostic::ready | diagnostic::active;
    case MasterState::run:
        return diagnostic::ready | diagnostic::active | diagnostic::run;
    case MasterState::busFail:
        return diagnostic::ready | diagnostic::bus;
    }
    return 0;
}

// What the master says about the ring.
struct MasterStatus
{
    struct Device
    {
        bool inRing = true;
        bool peripheralFault = false; // reported by the device, until it is confirmed

        friend bool operator==(const Device &, const Device &) = default;
    };
    // A segment is a remote-bus device and the cable before it.
    struct Segment
    {
        int segment = 0;
        bool switchedOff = false;
        std::uint32_t crcErrors = 0; // since the ring was started

        friend bool operator==(const Segment &, const Segment &) = default;
    };

    MasterState state = MasterState::ready;
    std::uint16_t statusBits = diagnostic::ready;
    std::uint16_t parameter = 0;              // the diagnostic parameter register as it is
    std::uint16_t errorCode = 0;              // 0: none
    std::optional<QString> configurationName; // file name of what the master stores; empty: it stores none
    std::vector<Device> devices;              // of the active configuration, in ring order
    std::vector<Segment> segments;

    bool isFaulty() const { return errorCode != 0; }
    QString faultText() const { return busFaultText(errorCode, parameter); }
    std::optional<FaultPlace> faultPlace() const
    {
        return isFaulty() ? faultPlaceOf(parameter) : std::nullopt;
    }

    friend bool operator==(const MasterStatus &, const MasterStatus &) = default;
};

} // namespace codewheel
