// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/job_round.h"
#include "transfer/transfer_plan.h"
#include "vocabulary/message.h"

namespace codewheel {

class Buses;

// What became of one wanted value.
enum class Became : std::uint8_t {
    written,      // and active
    alreadyThere, // known, or found by reading first: not written
    stored,       // in force before, and perhaps not stored
    restored,     // written, and then the previous value again
    confirmed,    // accepted, but not active: the encoder waits for run
    notActive,    // accepted, but not active: the encoder shows an error
    unknown,      // sent, and nobody knows whether the encoder has it
    notDone,
};
// The encoder has the value as it was wanted.
bool isThere(Became became);

struct AccountRow
{
    ParameterValue wanted;
    std::optional<Known> before{};
    std::optional<Known> after{}; // of a written one, the evidence that it is there
    Became became = Became::notDone;
};

struct AccountCamRow
{
    unsigned program = 1;
    Became became = Became::notDone;
};

// What was done with one encoder.
struct EncoderAccount
{
    Place place;
    QString station{};
    QString device{};
    QString deviceKey{};
    std::vector<AccountRow> rows{};
    std::vector<AccountCamRow> cams{};
    std::optional<std::int64_t> positionWanted{};
    bool positionSet = false;
    bool positionUnknown = false; // its preset was sent, and nobody knows whether the encoder has it
    std::optional<std::int64_t> positionBefore{};
    std::optional<std::int64_t> positionAfter{};
    bool isBegun = false;                  // something was sent to it
    std::optional<Refusal> why{};          // why not everything was done
    std::optional<ValueNote> notInForce{}; // its values that scale the position do not act, or may not
    bool onlyZeroSinceRun = false;
    EncoderState leftIn = EncoderState::notSeen;
    std::optional<LeftMode> leftInMode{};
    std::vector<Word> outLeft{}; // OUT may still hold one of these: its link was lost
    int eepromWrites = 0;
    int eepromWritesPerhaps = 0; // besides these
    QDateTime begun{};
    QDateTime ended{};

    // Whether the encoder has everything that was wanted, and works.
    bool isDone() const;
};

enum class TransferKind : std::uint8_t { write, clone, restore, replace };

// Exactly what was written where: made from a plan and the outcomes of its jobs.
struct TransferAccount
{
    TransferKind kind = TransferKind::write;
    QString source{}; // where the values come from, in the user's language; may be empty
    QDateTime at{};
    std::vector<EncoderAccount> encoders{};

    int count(Became became) const; // values and cam programs
    int eepromWrites() const;
    int eepromWritesPerhaps() const;
    bool isCancelled() const;
    bool isDone() const;
};

// `results` are those of the plan's encoders that are written. The buses say what is known now.
TransferAccount accountOf(const Buses &buses, TransferKind kind, const TransferPlan &plan,
                          const std::vector<EncoderResult> &results);

// For the message log: "transferDone", or that it was cancelled.
Message messageOf(const TransferAccount &account);

// What a round has to do for a plan.
std::vector<EncoderJobs> jobsOf(const TransferPlan &plan);

} // namespace codewheel
