// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/rod_scale.h"
#include "widgets/look/roles.h"

#include <QString>

#include <optional>

namespace codewheel {

// What the dial shows of a rod encoder. An empty value is never shown as 0.
struct RodState
{
    std::optional<qint64> position = {};       // steps
    std::optional<qint64> length = {};         // measuring length, steps
    std::optional<RodScale> scale = {};        // needs the length of the rod
    std::optional<bool> countsUpToTheEnd = {}; // the direction of counting
    std::optional<double> stepsPerSecond = {}; // positive: counts up
    bool isLastKnown = false;                  // the position is old, or the magnet is lost
    QString age = {};                          // of an old position: "20 s ago"
    QString note = {};                         // a sentence: what is wrong or missing, and what to do
    Role role = Role::inactive;                // of the note, and of the magnet

    // Before the position is changed: what will be shown behind that, by a second magnet.
    struct Then
    {
        std::optional<qint64> position = {}; // empty: it is not known
        std::optional<qint64> length = {};   // the scale of then, which may be another one than now
        std::optional<RodScale> scale = {};
        std::optional<bool> countsUpToTheEnd = {};

        friend bool operator==(const Then &, const Then &) = default;
    };
    std::optional<Then> then = {};

    friend bool operator==(const RodState &, const RodState &) = default;
};

// The magnet's place, 0 at the head to 1 at the end of the rod; nothing if the position lies outside the
// measuring length, or not everything is known.
std::optional<double> magnetPlace(const RodState &state);
std::optional<double> magnetPlaceThen(const RodState &state);

} // namespace codewheel
