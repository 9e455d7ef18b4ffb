// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/word.h"

#include <optional>

namespace codewheel {

// Which words are believed behind a link that may tear them: a read-out answer, of which one half may still
// be that of the word before, counts once it has stood for longer than any gateway copies. What never stands
// is left to whoever waits for it.
class StandingAnswer
{
public:
    static constexpr Instant time = std::chrono::milliseconds(50);     // assumed
    static constexpr Instant longest = std::chrono::milliseconds(500); // that it is waited for (assumed)

    bool counts(Word in, bool isAnswer, Instant now)
    {
        if (m_last != in) {
            m_last = in;
            m_since = now;
        }
        if (!isAnswer)
            m_openSince.reset();
        else if (!m_openSince)
            m_openSince = now;
        return !isAnswer || now - m_since >= time || now - *m_openSince >= longest;
    }
    void forget() { *this = {}; }

private:
    std::optional<Word> m_last;
    Instant m_since{};                  // so long it has been the same
    std::optional<Instant> m_openSince; // there have been answers
};

} // namespace codewheel
