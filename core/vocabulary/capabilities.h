// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"

#include <optional>

namespace codewheel {

// What a kind of encoder can do, as its description says. Views ask this, never the make.
struct Capabilities
{
    bool reads = false;                 // parameters can be read out
    bool writes = false;                // parameters can be written
    bool presets = false;               // the position can be set
    std::optional<CamAbilities> cams{}; // empty: none
    bool velocity = false;              // shows revolutions per minute on request
    bool manufacturerPreset = false;  // 60000000h: sets the position to the programmed preset again and again
    bool presetNeedsValue = false;    // the command that sets the position carries the value
    bool resets = false;              // to factory settings
    bool serialNumber = false;        // can be read
    bool readingHidesPosition = true; // reading sends words and takes the position away for some cycles
    bool presetIsStored = false;      // the initialised preset survives power-off without another write
    bool hasBattery = false;
    std::optional<int> eepromBudget; // writes the manual states; empty where it states none
    std::optional<int> eepromLimit;  // writes beyond which the manual guarantees nothing

    friend bool operator==(const Capabilities &, const Capabilities &) = default;
};

} // namespace codewheel
