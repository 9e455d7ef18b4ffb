// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/word_step.h"
#include "vocabulary/event.h"

namespace codewheel {

// How long a K3 driver waits, and for what. All of it can be set; the values are assumed, the manuals give
// none.
struct K3Timing
{
    Instant settle = std::chrono::milliseconds(
        20); // a word stays this long after its confirmation, and 00000000 after run
    Instant timeOut = std::chrono::seconds(2); // after that the encoder "does not answer"
    // 00000000h after run is position 0, or an encoder that has just lost power: it is watched this long for
    // signs of a restart.
    Instant restart = std::chrono::milliseconds(500);
    // 40000000h among words of the user: it is not acknowledged, and if the position is already at the preset
    // it has no visible effect.
    Instant presetActs = std::chrono::milliseconds(200);
};

// A step as the driver carries it out: the word, and what ends it.
struct K3Step : Step
{
    std::int64_t value = 0;               // parameter: wanted value
    std::optional<std::int64_t> expected; // readOut that verifies a write: what must be read
    bool isRepeated = false;              // parameter: its number may have been confirmed since the last run
    bool mustOperate = false;             // toNormal: only operation will do
    bool tolerateError = false;           // run: an error answer is an answer
    int holdCycles = 0;                   // word that is not acknowledged
    bool standsUntilItActs = false;       // word 40000000h
    bool inCamMode = false;               // word: what it means in cam mode decides what ends it
    unsigned camProgram = 0;              // camParameter, camReadOut: of this program
    bool isBetween = false;               // readOut that only stands between two others
    bool writesCams = false;              // follows from what was read of the program
};
using K3Steps = std::vector<K3Step>;

inline bool setsPosition(const K3Step &step)
{
    return step.kind == StepKind::initialisePreset || step.kind == StepKind::manufacturerPreset;
}

inline K3Step k3Step(StepKind kind, Word out)
{
    K3Step step;
    step.effect = effectOf(kind, out);
    step.kind = kind;
    step.out = out;
    return step;
}

} // namespace codewheel
