// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/answer_times.h"
#include "kinds/esc/protocol/esc_exchange.h"

#include <cstdint>
#include <optional>

namespace codewheel {

// What came instead of an answer, since the last one.
struct SinceAnswer
{
    std::uint64_t requests = 0;
    std::uint64_t strayBytes = 0; // no part of an answer in time
    bool isEchoed = false;        // the last request came back

    friend bool operator==(const SinceAnswer &, const SinceAnswer &) = default;
};

// The statistics of a line, or of one device on it, since it was opened.
struct EscLineFigures
{
    std::uint64_t requests = 0; // every sending counts
    std::uint64_t answers = 0;
    std::uint64_t timeOuts = 0;
    std::uint64_t retries = 0;
    std::uint64_t unanswered = 0; // after all retries
    std::uint64_t garbageBytes = 0;
    std::uint64_t lateBytes = 0;
    std::optional<AnswerTime> answerTime; // from the end of a request to that of its answer; empty: none yet
    SinceAnswer sinceAnswer{};

    friend bool operator==(const EscLineFigures &, const EscLineFigures &) = default;
};

// Counts for EscLineFigures. Line thread only.
class LineCounter
{
public:
    void note(const esc::ExchangeResult &result);
    void noteGarbage(std::size_t bytes) { m_figures.garbageBytes += bytes; }
    const EscLineFigures &figures() const { return m_figures; }
    // 0: no answer yet.
    Instant longestAnswer() const { return m_figures.answerTime ? m_figures.answerTime->longest : Instant{}; }

private:
    void noteMissing(const esc::ExchangeResult &result);

    EscLineFigures m_figures;
    AnswerTimes m_times;
};

} // namespace codewheel
