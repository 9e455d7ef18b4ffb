// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/reading.h"

#include <vector>

namespace codewheel {

// The words exchanged with a device in one cycle.
struct ExchangedWords
{
    Word in = 0;
    Word out = 0;

    friend bool operator==(const ExchangedWords &, const ExchangedWords &) = default;
};

// What an encoder showed in one cycle, or with one answer. What is empty it does not show from then on, until
// it is there again.
struct ShownValues
{
    Instant at{};
    std::optional<std::int64_t> position{}; // steps, as parameterized
    std::optional<double> stepsPerSecond{}; // as in its Reading
    std::optional<std::uint8_t> cams{};     // that are on; bit n: cam n
    std::optional<ExchangedWords> words{};  // empty: it has none

    friend bool operator==(const ShownValues &, const ShownValues &) = default;
};
using ShownSeries = std::vector<ShownValues>;

} // namespace codewheel
