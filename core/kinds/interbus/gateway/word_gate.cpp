// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/word_gate.h"

#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/profiles.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

bool isNear(std::int64_t steps)
{
    return steps < WordGate::nearBy && -steps < WordGate::nearBy;
}

} // namespace

WordGate::WordGate(std::optional<Profile> profile, int registers, Instant copyTime)
    : m_profile(profile)
    , m_canTear(registers > 1)
    , m_copyTime(copyTime)
{}

// K1, K2 and K4 have nothing but their position.
bool WordGate::mayMove(Word word) const
{
    if (m_profile == profile::k3)
        return k3::isOperation(word);
    if (m_profile == profile::la66)
        return !la66::isServiceMode(word);
    return m_profile == profile::k1 || m_profile == profile::k2 || m_profile == profile::k4;
}

// The shaft was there: it came by on its way from the one to the other.
bool WordGate::isOnTheWay(const Read &before, const Read &read, const Read &after) const
{
    const Instant longest = longestMovement + answersOfMovement * std::min(read.took, after.took);
    if (!mayMove(before.word) || !mayMove(read.word) || !mayMove(after.word) ||
        after.at - before.at > longest)
        return false;
    const std::int64_t there = std::int64_t{read.word} - before.word;
    const std::int64_t on = std::int64_t{after.word} - read.word;
    return isNear(there) && isNear(on) && there * on > 0;
}

bool WordGate::believe(const Read &read)
{
    m_word = read.word;
    m_wordAt = read.at;
    m_hasWord = true;
    return true;
}

// Seen from the last word believed, and from the read before: what lies far behind that, and near an older
// word, is torn.
bool WordGate::isJump(const Read &read, const std::optional<Read> &before) const
{
    const auto isNearTo = [&](Word word) { return isNear(std::int64_t{read.word} - word); };
    const bool isExpected = m_hasWord && mayMove(m_word) && read.at - m_wordAt <= longestMovement &&
                            isNearTo(m_word) && (!before || !mayMove(before->word) || isNearTo(before->word));
    return mayMove(read.word) && !isExpected;
}

bool WordGate::take(Word word, Instant at, Instant took)
{
    const Read read{word, at, took};
    const auto last = std::exchange(m_last, read);
    const auto beforeLast = std::exchange(m_beforeLast, last);
    const bool isEqual = last && last->word == word;
    const auto other = isEqual ? std::nullopt : std::exchange(m_other, last);
    if (!isEqual)
        m_sameSince = at;
    const bool isSame = isEqual && at - m_sameSince >= m_copyTime;
    const bool isSameThrice = isSame && beforeLast && beforeLast->word == word;
    if (!m_canTear || isSameThrice || (isSame && !isJump(read, beforeLast)))
        return believe(read);
    return last && other && isOnTheWay(*other, *last, read) && believe(*last);
}

bool WordGate::needsTime(bool isNextReadFar) const
{
    const bool stands = isNextReadFar && m_last && m_beforeLast && m_beforeLast->word == m_last->word;
    return m_canTear && m_last && (stands || !mayMove(m_last->word));
}

bool WordGate::canWait() const
{
    return m_hasWord && m_last && mayMove(m_word) && mayMove(m_last->word) &&
           isNear(std::int64_t{m_last->word} - m_word) && m_last->at - m_wordAt <= shortWait;
}

void WordGate::forget()
{
    m_last.reset();
    m_beforeLast.reset();
    m_other.reset();
    m_hasWord = false;
}

} // namespace codewheel
