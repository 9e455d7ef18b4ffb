// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/exchange.h"
#include "vocabulary/job.h"
#include "vocabulary/known.h"
#include "vocabulary/reading.h"
#include "vocabulary/refusal.h"
#include "vocabulary/step.h"

#include <QString>

#include <variant>
#include <vector>

namespace codewheel {

// Sent when a step begins, starts waiting, or is done.
struct Progress
{
    JobId job = 0;
    int index = 0;             // of the step, from 0
    std::vector<Step> steps;   // everything planned so far
    bool waitsForUser = false; // Pace::byHand: steps[index] will be sent by proceed()
    ParameterValues confirmed; // what the encoder has taken so far, not yet active
    bool canRestore = false;   // the previous values are known for everything confirmed
    bool setsPosition = false; // a word or request was sent that sets the position: that cannot be undone
    bool hasTaken = false;     // the encoder has taken something, or may have: cancel has to say how
};

// What was sent, or was on its way, when a job ended, and what nobody has seen the answer to: the link was
// lost, the computer slept, or the bus was stopped. Whether the encoder has it is not known until it is read.
struct InDoubt
{
    ParameterValues values{}; // perhaps active, or confirmed
    bool reset = false;       // to default
    bool position = false;    // perhaps set
    std::vector<unsigned> camPrograms{};
    int eepromWrites = 0;               // that this may have cost, besides those counted
    std::vector<Parameter> uncounted{}; // of the values: one of these writes each, if the encoder has it
    std::vector<Word> out{};            // that OUT may still hold, besides 0: the likeliest first

    friend bool operator==(const InDoubt &, const InDoubt &) = default;
    bool hasSomething() const { return *this != InDoubt(); }
};

// The mode a job that did not succeed has left the encoder in, which is another than before.
struct LeftMode
{
    std::optional<Mode> mode{}; // empty: not known
    std::optional<unsigned> camProgram{};

    friend bool operator==(const LeftMode &, const LeftMode &) = default;
};

struct Outcome
{
    JobId job = 0;
    Result<void> result;
    int eepromWrites = 0; // counted the way the device counts them
    EncoderState leftIn = EncoderState::notSeen;
    bool foundInParameterization = false; // before it began, by others or by an earlier job
    bool resetWaits = false;              // for run: the reset to default was sent
    std::optional<LeftMode> leftInMode{};
    ParameterValues written;      // confirmed and activated by run
    ParameterValues confirmed{};  // but not activated: takes effect only once run is sent
    ParameterValues alreadyThere; // left out because read and equal
    ParameterValues stored{};     // likewise, but perhaps not stored before
    ParameterValues setAlong{};   // changed by the encoder itself along with what was written, and read back
    ParameterValues read;         // ReadParameters: what the encoder reported
    // IN was 00000000h from run to the end: position 0, or no power. Without a read-out the two cannot be
    // told apart.
    bool onlyZeroSinceRun = false;
    std::vector<CamProgram> camsRead{};
    std::vector<CamProgram> camsWritten{};      // read back where the job could
    std::optional<std::int64_t> positionBefore; // steps; SetPreset, on a serial line also for writing
    std::optional<std::int64_t> positionAfter;
    bool isPositionSet = false; // by a step that was carried out before the job was cancelled
    // The previous values were restored: how it is known that the encoder has them again. They are in
    // `written` and `camsWritten`.
    std::optional<Evidence> restored{};
    InDoubt inDoubt{};
    ParameterValues
        notActive{}; // confirmed, but then the encoder showed an error instead of working with them
};

// Whether nobody sees any more what a job that ends because of this has sent.
inline bool endsOutOfSight(const Refusal &why)
{
    return why.kind == RefusalKind::link || why.id == RefusalId::computerSlept ||
           why.id == RefusalId::busStopped;
}

// What is known of the encoder changed, whatever caused it: a job, or words sent from the monitor.
struct KnowledgeChanged
{
    std::vector<Known> known;
    std::vector<Parameter> noLongerKnown;
    std::vector<KnownCams> cams{};
    std::vector<unsigned> camsNoLongerKnown{}; // cam programs
    QString version{};                         // the version a serial encoder reported; empty: none
    int eepromWrites = 0;                      // since the last such event, jobs included
};

// InDoubt: of words sent by hand, whose EEPROM writes are counted by whoever sent them. That of a job is in
// its outcome.
using Event = std::variant<Progress, Outcome, KnowledgeChanged, InDoubt>;

inline bool endedOutOfSight(const Outcome &outcome)
{
    return !outcome.result && endsOutOfSight(outcome.result.error());
}

} // namespace codewheel
