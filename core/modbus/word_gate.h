// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/profile.h"
#include "words/k3_word.h"

#include <optional>

namespace codewheel {

// Whether a word read from a gateway can be believed. The gateway may tear a 32-bit word: one register is
// from before a change, the other from after it. A word of a handshake is believed when two reads in a row
// give it (spec modbus-gateway.md). A position that moves never does that; it is believed when it is the
// middle one of three reads in a row that are positions with the same high register and low registers that
// are near each other: whatever tears a word changes one of these.
class WordGate
{
public:
    // Empty: not known, so no word is taken for a moving position. `registers`: a word of one cannot be torn.
    WordGate(std::optional<Profile> profile, int registers);

    // Takes what one read gave, and says whether there is a word that can be believed; it is word() then.
    bool take(Word read);
    Word word() const { return m_word; } // the last one that could be believed; 0: none yet
    bool hasWord() const { return m_hasWord; }
    // The reads so far say nothing any more: the connection was interrupted.
    void forget();

private:
    bool mayMove(Word word) const;
    bool isBetween(Word before, Word word, Word after) const;
    bool believe(Word word);

    std::optional<Profile> m_profile;
    bool m_canTear;
    std::optional<Word> m_last;
    std::optional<Word> m_beforeLast;
    Word m_word = 0;
    bool m_hasWord = false;
};

} // namespace codewheel
