// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/word.h"

#include <cstdint>
#include <vector>

namespace codewheel {

// Which words may be in the OUT registers of one device without somebody else having written them: the one
// written last, and for a while those that it replaces, since a gateway may show a word later than it has
// acknowledged it. Used by GatewayLink.
class OwnWord
{
public:
    // Until a word that was written must be read back (assumed).
    static constexpr Instant gatewayLag = std::chrono::seconds(1);

    // As it is on the gateway when nobody else is expected to write any more.
    void found(Word word);
    // It is going to be written: from now on it may be there.
    void write(Word word, Instant now);
    // That was not answered, and may still be carried out: what it replaces stays ours until wasAnswered().
    void wasNotAnswered() { replacementIs(Replacement::unanswered); }
    // It has not left: what it was to replace is there.
    void wasNotSent() { replacementIs(Replacement::unsent); }
    void wasAnswered(Instant now);
    // The last one has had its time to show: from now on no other is ours, unless the last one never left.
    void isThere();
    // Whether this word is the one of ours that is to be there in the end.
    bool isShownBy(Word there) const;
    // Whether this word, as read back, is ours. What was replaced by it does not come back.
    bool takes(Word there, Instant now);
    bool isKnown() const { return !m_words.empty(); }
    Word word() const { return m_words.back().word; }
    void forget() { m_words.clear(); }

private:
    enum class Replacement : std::uint8_t { answered, unsent, unanswered };
    struct Written
    {
        Word word = 0;
        Instant replacedAt{};                            // by the next one
        Replacement replacement = Replacement::answered; // what became of the next one
    };

    void replacementIs(Replacement replacement);
    bool hasLeft() const;

    std::vector<Written> m_words; // oldest first
    bool m_isAnswered = true;     // the last one was
};

} // namespace codewheel
