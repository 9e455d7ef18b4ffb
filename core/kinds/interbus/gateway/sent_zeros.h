// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <mutex>
#include <optional>
#include <vector>

namespace codewheel {

// What became of the zeros of an ALARM STOP since their link was made, by its clock; each the first time.
struct SentZeros
{
    std::optional<Instant> sentAt{};
    std::optional<Instant> acknowledgedAt{}; // all of them
    std::optional<Instant> readBackAt{};     // all of OUT as 00000000
    bool mayHaveArrived = false;             // some were sent, and not refused
    std::vector<std::size_t> refusedBy{};    // devices, of which the others have acknowledged theirs
};

// Kept by the thread that exchanges, while others may look at it.
class ZerosRecord
{
public:
    SentZeros told() const;
    void send(Instant now);
    // What came of those.
    void acknowledged(Instant now);
    void unanswered();
    void refused();
    void refusedBy(std::vector<std::size_t> devices);
    void notSent();
    void readBack(Instant now);

private:
    mutable std::mutex m_mutex;
    SentZeros m_told;
    SentZeros m_before; // the last ones were sent
};

} // namespace codewheel
