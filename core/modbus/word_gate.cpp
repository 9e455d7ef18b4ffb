// SPDX-License-Identifier: GPL-3.0-or-later
#include "modbus/word_gate.h"

#include "words/la66_word.h"

#include <utility>

namespace codewheel {
namespace {

constexpr int registerBits = 16;
constexpr int nearBy = 0x8000; // steps between two reads in a row

// The low registers, without a carry into the high ones.
bool areNear(Word one, Word other)
{
    const int distance = static_cast<int>(one & 0xFFFF) - static_cast<int>(other & 0xFFFF);
    return (one >> registerBits) == (other >> registerBits) && distance < nearBy && -distance < nearBy;
}

} // namespace

WordGate::WordGate(std::optional<Profile> profile, int registers)
    : m_profile(profile)
    , m_canTear(registers > 1)
{}

// K1, K2 and K4 have nothing but their position.
bool WordGate::mayMove(Word word) const
{
    if (!m_profile)
        return false;
    switch (*m_profile) {
    case Profile::k3:
        return k3::isOperation(word);
    case Profile::la66:
        return !la66::isServiceMode(word);
    case Profile::k1:
    case Profile::k2:
    case Profile::k4:
        return true;
    case Profile::esc:
        return false;
    }
    return false;
}

bool WordGate::isBetween(Word before, Word word, Word after) const
{
    return mayMove(before) && mayMove(word) && mayMove(after) && areNear(before, word) &&
           areNear(word, after);
}

bool WordGate::believe(Word word)
{
    m_word = word;
    m_hasWord = true;
    return true;
}

bool WordGate::take(Word read)
{
    const auto last = std::exchange(m_last, read);
    const auto beforeLast = std::exchange(m_beforeLast, last);
    if (!m_canTear || last == read)
        return believe(read);
    return last && beforeLast && isBetween(*beforeLast, *last, read) && believe(*last);
}

void WordGate::forget()
{
    m_last.reset();
    m_beforeLast.reset();
    m_hasWord = false;
}

} // namespace codewheel
