// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/word.h"

#include <optional>

namespace codewheel {

// What is believed of the words behind a link that may tear them: a read-out answer, of which one half may still
// be that of the word before, counts once it has stood for longer than any gateway copies. Until then it is
// taken as if the word before still stood.
class StandingAnswer
{
public:
    static constexpr Instant time = std::chrono::milliseconds(50); // assumed

    Word believed(Word in, bool isAnswer, Instant now)
    {
        if (m_last != in) {
            m_last = in;
            m_since = now;
        }
        if (!isAnswer || !m_believed || now - m_since >= time)
            m_believed = in;
        return *m_believed;
    }
    void forget()
    {
        m_last.reset();
        m_believed.reset();
    }

private:
    std::optional<Word> m_last;
    Instant m_since{}; // so long it has been the same
    std::optional<Word> m_believed;
};

} // namespace codewheel
