// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace codewheel {

// How long answers have taken.
struct AnswerTime
{
    Instant shortest{};
    Instant median{}; // of the newest AnswerTimes::samples
    Instant longest{};

    friend bool operator==(const AnswerTime &, const AnswerTime &) = default;
};

// Measures it, for the statistics of a link. Its thread only.
class AnswerTimes
{
public:
    static constexpr std::size_t samples = 1'000;

    AnswerTime note(Instant time); // with this one

private:
    std::optional<AnswerTime> m_told;
    std::vector<Instant> m_times; // ring buffer of the newest
    std::size_t m_oldest = 0;
    std::vector<Instant> m_sorted; // the same, so that the median needs no sorting in each exchange
};

} // namespace codewheel
