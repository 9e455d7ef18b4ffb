// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// What has happened to a simulated ESC encoder, and how its inputs are wired. Set by the trainer.
struct EscCondition
{
    bool powered = true;
    bool mute = false; // hears and acts, but says nothing
    bool temperatureExceeded = false;
    bool batteryLimit = false; // warning: will soon be flat
    bool batteryFlat = false;
    bool lightControl = false; // the light control is at its limit
    bool positionError = false;
    bool vrHigh = false; // input VR at +UB: values decrease
    bool stOpen = false; // RS-422: input ST not tied to +UB, so no ESC command works

    friend bool operator==(const EscCondition &, const EscCondition &) = default;
};

// What its shaft and its position contribute.
struct EscMotion
{
    bool standsStill = true;
    bool turnsCcw = false;
    bool tooFast = false; // frequency exceeded
    bool aboveUpperLimit = false;
    bool belowLowerLimit = false;
    bool atPreset = false; // reference reached
};

// What A and E answer (manual, "Alarm Parameters" and "Warning Parameters").
std::uint32_t escAlarms(const EscCondition &condition, const EscMotion &motion);
std::uint32_t escWarnings(const EscCondition &condition, const EscMotion &motion);

} // namespace codewheel
