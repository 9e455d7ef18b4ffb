// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/own_word.h"

#include <iterator>
#include <utility>

namespace codewheel {

void OwnWord::found(Word word)
{
    m_words.assign(1, {word});
}

void OwnWord::write(Word word, Instant now)
{
    if (isKnown() && m_words.back().word == word)
        return;
    if (isKnown())
        m_words.back().replacedAt = now;
    while (m_words.size() > 1 && !m_words.front().mayStayForever &&
           now - m_words.front().replacedAt >= gatewayLag)
        m_words.erase(m_words.begin());
    m_words.push_back({word});
}

void OwnWord::wasNotAnswered()
{
    if (m_words.size() > 1)
        m_words[m_words.size() - 2].mayStayForever = true;
}

void OwnWord::wasAnswered(Instant now)
{
    for (Written &own : m_words)
        if (std::exchange(own.mayStayForever, false))
            own.replacedAt = now;
}

bool OwnWord::takes(Word there, Instant now)
{
    if (!isKnown())
        return true;
    // The oldest of those that are equal: the newest may not have arrived yet, nor what came in between.
    for (auto own = m_words.begin(); own != m_words.end(); ++own) {
        const bool isLast = std::next(own) == m_words.end();
        const bool mayShow = isLast || own->mayStayForever || now - own->replacedAt < gatewayLag;
        if (own->word == there && mayShow) {
            m_words.erase(m_words.begin(), own);
            return true;
        }
    }
    return false;
}

} // namespace codewheel
