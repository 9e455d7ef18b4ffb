// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/own_word.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace codewheel {

void OwnWord::found(Word word)
{
    m_words.assign(1, {word});
    m_isAnswered = true;
}

void OwnWord::write(Word word, Instant now)
{
    if (isKnown() && m_words.back().word == word)
        return;
    if (isKnown())
        m_words.back().replacedAt = now;
    while (m_words.size() > 1 && m_words.front().replacement == Replacement::answered &&
           now - m_words.front().replacedAt >= gatewayLag)
        m_words.erase(m_words.begin());
    m_words.push_back({word});
    m_isAnswered = false;
}

// One that was answered before arrives at most once more; one that may have been sent stays so.
void OwnWord::replacementIs(Replacement replacement)
{
    if (m_isAnswered || m_words.size() < 2)
        return;
    Replacement &its = m_words[m_words.size() - 2].replacement;
    its = std::max(its, replacement);
}

void OwnWord::wasAnswered(Instant now)
{
    m_isAnswered = true;
    for (Written &own : m_words)
        if (std::exchange(own.replacement, Replacement::answered) != Replacement::answered)
            own.replacedAt = now;
}

bool OwnWord::hasLeft() const
{
    return m_words.size() < 2 || m_words[m_words.size() - 2].replacement != Replacement::unsent;
}

void OwnWord::isThere()
{
    if (isKnown())
        m_words.erase(m_words.begin(), m_words.end() - (hasLeft() ? 1 : 2));
}

bool OwnWord::isShownBy(Word there) const
{
    return !isKnown() || word() == there || (!hasLeft() && m_words[m_words.size() - 2].word == there);
}

bool OwnWord::takes(Word there, Instant now)
{
    if (!isKnown())
        return true;
    // The oldest of those that are equal: the newest may not have arrived yet, nor what came in between.
    for (auto own = m_words.begin(); own != m_words.end(); ++own) {
        const bool isLast = std::next(own) == m_words.end();
        const bool mayShow =
            isLast || own->replacement != Replacement::answered || now - own->replacedAt < gatewayLag;
        if (own->word == there && mayShow) {
            m_words.erase(m_words.begin(), own);
            return true;
        }
    }
    return false;
}

} // namespace codewheel
