// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_answer.h"

#include <vector>

namespace codewheel {

// The reads of one value, in pairs: it is accepted when the two reads of one try agree, since the protocol
// has no checksum. A failed try counts for nothing, so that one corrupted answer never outvotes another.
class EscAgreement
{
public:
    enum class State : std::uint8_t { wantsMore, agreed, disagreed };

    explicit EscAgreement(int tries = 1)
        : m_tries(tries)
    {}

    State add(const esc::Answer &answer)
    {
        m_reads.push_back(answer);
        if (m_reads.size() % 2 != 0)
            return State::wantsMore;
        if (first() == last())
            return State::agreed;
        return static_cast<int>(m_reads.size() / 2) < m_tries ? State::wantsMore : State::disagreed;
    }

    // Of the last try; valid once add() returned agreed or disagreed.
    const esc::Answer &first() const { return m_reads[m_reads.size() - 2]; }
    const esc::Answer &last() const { return m_reads.back(); }

private:
    int m_tries;
    std::vector<esc::Answer> m_reads;
};

} // namespace codewheel
