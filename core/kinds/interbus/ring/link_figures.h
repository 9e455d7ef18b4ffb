// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/answer_times.h"

#include <cstdint>
#include <map>
#include <optional>

namespace codewheel {

// The statistics of a link that reaches the ring by transactions (a gateway), since it was made.
struct LinkFigures
{
    std::uint64_t transactions = 0; // every sending counts
    std::uint64_t exchanges = 0;    // that were completed
    std::uint64_t retries = 0;
    std::uint64_t noAnswers = 0;             // within the time-out
    std::uint64_t wrongAnswers = 0;          // of a wrong length or unit, or damaged
    std::map<int, std::uint64_t> exceptions; // by code
    std::uint64_t connections = 0;           // that were made
    std::uint64_t reconnections = 0;         // of these, since the gateway had closed the one before
    std::uint64_t closedAfterEach = 0;       // of these, since it closes each one after its answer
    bool closesAfterEach = false;            // it does so now
    std::uint64_t strayBytes = 0;            // on a serial line, that belong to no answer
    std::uint64_t echoes = 0;                // of our own requests
    std::uint64_t closed = 0;                // connections that were lost
    std::uint64_t tornWords = 0;             // words that were not believed
    std::optional<AnswerTime> roundTrip{};   // of a transaction; empty: none was answered yet
    double exchangesPerSecond = 0;           // over about the last second
    std::optional<std::uint16_t> status{};   // the status register of a gateway; empty: it has none

    friend bool operator==(const LinkFigures &, const LinkFigures &) = default;
};

} // namespace codewheel
