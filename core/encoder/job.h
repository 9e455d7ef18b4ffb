// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/parameter.h"
#include "words/k3_word.h"

#include <cstdint>
#include <variant>

namespace codewheel {

using JobId = std::uint64_t;

// Read the named values. Takes the position away for some cycles each.
struct ReadParameters
{
    std::vector<Parameter> parameters;
};

// Write the values in the order given, then run.
struct WriteParameters
{
    ParameterValues values;
    // Read first and leave out what the encoder already has; where it cannot be read, what is known is left
    // out by the caller.
    bool onlyWhatDiffers = false;
    // Values from before, for "restore previous"; those read by the job itself are added to them.
    ParameterValues previous;
    // Afterwards initialise the preset (40000000h).
    bool initialisePreset = false;
};

// Write the preset value if one is given, then initialise it (40000000h).
struct SetPreset
{
    std::optional<std::int64_t> value;
};

// Send words as they are, each until it is acknowledged, or for holdCycles where nothing acknowledges.
struct SendWords
{
    std::vector<Word> words;
    int holdCycles = 3;
};

// Bring an encoder that was left in parameterization or error back to operation: run, and then, where values
// are given, write them and run again.
struct EndParameterization
{
    ParameterValues restore;
};

using Job = std::variant<ReadParameters, WriteParameters, SetPreset, SendWords, EndParameterization>;

// Whether 40000000h is among its words: in cam mode that sets the start of cam 0 instead.
inline bool initialisesPreset(const Job &job)
{
    const auto *write = std::get_if<WriteParameters>(&job);
    return std::holds_alternative<SetPreset>(job) || (write != nullptr && write->initialisePreset);
}

// By hand, the job waits before each change of OUT until proceed() is called.
enum class Pace : std::uint8_t { byItself, byHand };

// What to do with an encoder that has already confirmed something when the job is cancelled.
enum class OnCancel : std::uint8_t {
    restorePrevious,  // run, then write the values from before, then run
    runWithWhatItHas, // run
    leaveAsIs,        // OUT back to 0, the encoder stays in parameterization
};

} // namespace codewheel
