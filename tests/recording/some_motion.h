// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/shown_values.h"

#include <random>

namespace codewheel::test {

// A shaft that turns, stands, jumps and is lost at times.
inline ShownSeries someMotion(std::mt19937_64 &random, Instant &at, std::size_t count)
{
    ShownSeries values;
    std::int64_t position = 1'000;
    while (values.size() < count) {
        const auto kind = random() % 6;
        const std::size_t stretch = 1 + random() % 200;
        for (std::size_t i = 0; i < stretch && values.size() < count; ++i) {
            at += Instant(900 + static_cast<std::int64_t>(random() % 200));
            position += kind < 3 ? 7 + static_cast<std::int64_t>(random() % 3) : 0;
            ShownValues shown{.at = at, .position = position};
            shown.words = ExchangedWords{static_cast<Word>(position * 3), static_cast<Word>(i % 7 == 0)};
            if (kind == 5)
                shown = {.at = at};
            values.push_back(shown);
        }
        position += kind == 4 ? 100'000 : 0;
    }
    return values;
}

} // namespace codewheel::test
