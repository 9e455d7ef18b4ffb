// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/value_notes.h"
#include "vocabulary/event.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace codewheel {

// One handshake from its first word to its outcome, as shown in the report.
struct HandshakeRecord
{
    QString place;  // "1.0"
    QString device; // "FRABA OCD-IB K3"
    std::optional<std::int64_t> serialNumber;
    QDateTime begun;
    QDateTime ended;
    Instant endedAt{}; // by the clock of the bus
    WriteParameters job;
    bool setsPosition = false;
    bool setsByPreset = false;                 // to its programmed preset, which an offset is added to
    std::optional<std::int64_t> setPositionTo; // nothing: to a preset that is not known
    std::optional<ValueNote> leftOut;          // of what was wanted
    std::vector<Known> before;                 // what was known
    std::vector<Known> after;
    std::vector<Exchange> rows;
    std::optional<std::int64_t> positionBefore;
    std::optional<std::int64_t> positionAfter;
    Progress progress;               // the last one
    std::optional<Outcome> outcome;  // nothing: still running
    std::optional<Outcome> recovery; // of bringing it back after a cancel or an error
    int eepromWritesInAll = 0;       // by this program, including this handshake

    // Of bringing it back, if that was tried, or else of the handshake; nothing: still running.
    const std::optional<Outcome> &last() const { return recovery ? recovery : outcome; }
    // Whether the encoder has taken a value in this handshake that a cancel would have to deal with.
    bool hasTaken() const;
    ParameterValues taken() const; // confirmed, or active by run
    // Brought back after that or not: it stays set.
    bool isPositionSet() const { return outcome && (outcome->result || outcome->isPositionSet); }

    // On a serial line a single read may be damaged: the job's positions are those on which reads agreed.
    // Bringing the encoder back keeps the position before.
    void takePositions(const Outcome &last);
};

} // namespace codewheel
