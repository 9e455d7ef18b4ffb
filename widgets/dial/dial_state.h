// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"

#include <QString>

#include <cmath>
#include <optional>

namespace codewheel {

// What the dial shows of a shaft. An empty value is never shown as 0.
struct DialState
{
    std::optional<double> turnFraction = {}; // 0 to 1 of a turn, clockwise; needs the steps per revolution
    std::optional<qint64> position = {};     // steps, as parameterized
    std::optional<qint64> turn = {};         // whole turns, from 0
    std::optional<qint64> velocity = {};     // rpm, as the encoder sends it: positive where positions rise
    std::optional<double> rpm = {};          // positive: clockwise
    bool isLastKnown = false;                // all of it is old: its state now is not known
    QString age = {};                        // when isLastKnown: "20 s ago"
    QString note = {};                       // a sentence: what is wrong or missing, and how to get it
    Role role = Role::inactive;              // of the note, and of the pointer

    // Before the position is changed: what will be shown behind that, by a second pointer.
    struct Then
    {
        std::optional<qint64> position = {}; // empty: it is not known
        std::optional<double> turnFraction = {};

        friend bool operator==(const Then &, const Then &) = default;
    };
    std::optional<Then> then = {};

    friend bool operator==(const DialState &, const DialState &) = default;
};

// The fraction of a turn by which the disc is turned clockwise at a position of so many turns.
inline double partOfTurn(double turns, bool clockwise)
{
    const double part = turns - std::floor(turns);
    return clockwise || part == 0 ? part : 1 - part;
}

} // namespace codewheel
