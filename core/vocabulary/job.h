// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"
#include "vocabulary/mode.h"
#include "vocabulary/parameter.h"
#include "vocabulary/word.h"

#include <cstdint>
#include <variant>

namespace codewheel {

using JobId = std::uint64_t;

// Read the named values. Each takes the position away for some cycles.
struct ReadParameters
{
    std::vector<Parameter> parameters;
};

// Write the values in the order given, then run.
struct WriteParameters
{
    ParameterValues values;
    // Read first and leave out what the encoder already has; where it cannot be read, the caller leaves out
    // what is known.
    bool onlyWhatDiffers = false;
    // The previous values, for "restore previous"; those the job reads itself are added to them.
    ParameterValues previous;
    // Afterwards initialise the preset (40000000h).
    bool initialisePreset = false;
};

// How the position is set to the preset.
enum class PresetCommand : std::uint8_t {
    profile,      // 40000000h; LA-66: service 6
    manufacturer, // 60000000h, one bus cycle long (FRABA manual 5.4.1)
};

// Write the preset value if one is given, then set the position to it.
struct SetPreset
{
    std::optional<std::int64_t> value;
    PresetCommand command = PresetCommand::profile;
};

// Switch an encoder that has several modes to one of them (FRABA manual 5.4.2, 5.4.4). Leaving a cam program
// that was changed stores it: one EEPROM write.
struct SwitchMode
{
    Mode mode = Mode::position;
    unsigned camProgram = 0; // 1..8; Mode::cam

    friend bool operator==(const SwitchMode &, const SwitchMode &) = default;
};

// Back to factory settings (0E000000h, then run).
struct ResetToDefault
{};

// Keep what is in force without supply, where that is a step of its own (ProtocolRules::storesByStep()).
struct StoreParameters
{};

// Read cam programs, each in its own cam mode (FRABA manual 5.4.4).
struct ReadCams
{
    std::vector<unsigned> programs;       // 1..8
    std::optional<SwitchMode> afterwards; // empty: stays in the last program
};

// Write cam programs. A program is stored in EEPROM when it is left.
struct WriteCams
{
    std::vector<CamProgram> programs;
    bool onlyWhatDiffers = true; // read each first, and write only what differs
    std::optional<SwitchMode> afterwards;
};

// Send words as they are, each until it is acknowledged, or for holdCycles where it is not acknowledged.
struct SendWords
{
    enum class AfterError : std::uint8_t {
        stop, // an error of the encoder ends the job
        goOn, // with the next word; the job fails if the last one, or the encoder's final state, is an error
    };

    std::vector<Word> words;
    int holdCycles = 3;
    AfterError afterError = AfterError::stop;
    // 40000000h stays in OUT, for holdCycles at least, until the position has jumped, or could have.
    bool presetStandsUntilItActs = true;
};

// Bring an encoder that was left in parameterization or error back to operation: run, and then, where values
// are given, write them and run again.
struct EndParameterization
{
    ParameterValues restore;
};

using Job = std::variant<ReadParameters, WriteParameters, SetPreset, SendWords, EndParameterization,
                         SwitchMode, ResetToDefault, ReadCams, WriteCams, StoreParameters>;

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
    restorePrevious,  // run, then write the previous values, then run
    runWithWhatItHas, // run
    leaveAsIs,        // OUT back to 0, the encoder stays in parameterization
    // OUT back to 0 if the encoder has taken nothing. Otherwise the job goes on and a Progress says so
    // (hasTaken): whoever cancels then asks how. The driver decides, since a snapshot may be out of date.
    ifNothingTaken,
};

} // namespace codewheel
