// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/local_text.h"

#include <QStringList>

#include <vector>

namespace codewheel {

// The tables a manual has besides its protocol, for the device panel and the command line. Each names the
// manual's chapter.

struct Pin
{
    QString pin; // "1", "PH"
    LocalText signal;
    LocalText remark; // may be empty

    friend bool operator==(const Pin &, const Pin &) = default;
};

struct Connector
{
    LocalText name;
    LocalText chapter;
    std::vector<Pin> pins;

    friend bool operator==(const Connector &, const Connector &) = default;
};

struct Led
{
    QString name; // "UL (PWR)"
    LocalText colour;
    LocalText meaning;

    friend bool operator==(const Led &, const Led &) = default;
};

// Which LEDs are on or blink together, and what that means.
struct LedState
{
    QStringList on; // names of LEDs
    QStringList blinking;
    LocalText meaning;

    friend bool operator==(const LedState &, const LedState &) = default;
};

struct Leds
{
    LocalText chapter;
    std::vector<Led> lamps;
    std::vector<LedState> states;

    friend bool operator==(const Leds &, const Leds &) = default;
};

// Technical data, as the manual groups it: electrical, mechanical, environment.
struct LimitTable
{
    struct Row
    {
        LocalText name;
        LocalText value;

        friend bool operator==(const Row &, const Row &) = default;
    };

    LocalText name;
    LocalText chapter;
    std::vector<Row> rows;

    friend bool operator==(const LimitTable &, const LimitTable &) = default;
};

struct Supply
{
    LocalText value; // empty: the manual does not state it
    LocalText chapter;

    friend bool operator==(const Supply &, const Supply &) = default;
};

} // namespace codewheel
