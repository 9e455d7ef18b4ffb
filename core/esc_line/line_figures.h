// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "esc/esc_exchange.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace codewheel {

// The statistics of a line, or of one device on it, since it was opened.
struct LineFigures
{
    struct AnswerTime // from the end of a request to the end of its answer
    {
        Instant shortest{};
        Instant median{}; // of the newest LineCounter::samples
        Instant longest{};

        friend bool operator==(const AnswerTime &, const AnswerTime &) = default;
    };

    std::uint64_t requests = 0; // every sending counts
    std::uint64_t answers = 0;
    std::uint64_t timeOuts = 0;
    std::uint64_t retries = 0;
    std::uint64_t unanswered = 0; // after all retries
    std::uint64_t garbageBytes = 0;
    std::uint64_t lateBytes = 0;
    std::optional<AnswerTime> answerTime; // empty: no answer yet

    friend bool operator==(const LineFigures &, const LineFigures &) = default;
};

// Counts for LineFigures. Line thread only.
class LineCounter
{
public:
    static constexpr std::size_t samples = 1'000;

    void note(const esc::ExchangeResult &result);
    void noteGarbage(std::size_t bytes) { m_figures.garbageBytes += bytes; }
    const LineFigures &figures() const { return m_figures; }
    Instant longestAnswer() const; // 0: no answer yet

private:
    void noteTime(Instant time);

    LineFigures m_figures;
    std::vector<Instant> m_times; // ring buffer of the newest
    std::size_t m_oldest = 0;
    std::vector<Instant> m_sorted; // the same, so that the median needs no sorting in each exchange
};

} // namespace codewheel
