// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/profile.h"
#include "vocabulary/instant.h"
#include "vocabulary/word.h"

#include <optional>

namespace codewheel {

// Whether a word read from a gateway can be believed. The gateway may tear a 32-bit word: one register is
// from before a change, the other from after it, for as long as its copy takes. A word of a handshake is
// believed when two reads in a row give it, with that time between them (spec modbus-gateway.md). A position
// that moves never does that; it is believed when it is the middle one of three different words in a row that
// are positions, one behind the other and near each other: a word torn at the carry from one register into
// the other is not between its neighbours, or 65536 steps away. A shaft that trembles there may tear two
// reads in a row alike, so a position that is not near the last one believed, and near the read before, needs
// three equal reads.
class WordGate
{
public:
    static constexpr int nearBy = 0x8000; // steps between two reads in a row (assumed)
    // A position near the last one believed may wait that long for what comes next (assumed).
    static constexpr Instant shortWait = std::chrono::milliseconds(10);
    // Three reads that take longer than this, and than the answers of a slow gateway take, say nothing about
    // the one in the middle (assumed).
    static constexpr Instant longestMovement = std::chrono::milliseconds(500);
    static constexpr int answersOfMovement = 4;

    // Empty: not known, so no word is taken for a moving position. `registers`: a word of one cannot be torn.
    // `copyTime`: so far apart the gateway may copy the registers of a word.
    WordGate(std::optional<Profile> profile, int registers, Instant copyTime);

    // Takes what one read gave, `took` after it was asked for, and says whether there is a word that can be
    // believed; it is word() then.
    bool take(Word read, Instant at, Instant took = {});
    Word word() const { return m_word; } // the last one that could be believed; 0: none yet
    Instant readAt() const { return m_wordAt; }
    bool hasWord() const { return m_hasWord; }
    // The last read counts once it has stood for the copy time; a position that moves needs another read, and
    // no time, but for one that stands between two copies of the gateway, if the next read is far away.
    bool needsTime(bool isNextReadFar) const;
    // The next reads will tell: it is a position near the last one believed, a moment ago.
    bool canWait() const;
    // The reads so far say nothing any more: the connection was interrupted.
    void forget();

private:
    struct Read
    {
        Word word = 0;
        Instant at{};
        Instant took{};
    };

    bool mayMove(Word word) const;
    bool isOnTheWay(const Read &before, const Read &read, const Read &after) const;
    bool isJump(const Read &read, const std::optional<Read> &before) const;
    bool believe(const Read &read);

    std::optional<Profile> m_profile;
    bool m_canTear;
    Instant m_copyTime;
    Instant m_sameSince{}; // the first of the equal reads that end with the last one
    std::optional<Read> m_last;
    std::optional<Read> m_beforeLast;
    std::optional<Read> m_other; // the last one before that was another word than the last
    Word m_word = 0;
    Instant m_wordAt{};
    bool m_hasWord = false;
};

} // namespace codewheel
