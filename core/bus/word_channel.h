// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/freshness.h"
#include "vocabulary/place.h"
#include "vocabulary/refusal.h"
#include "vocabulary/word.h"

#include <QDateTime>
#include <QObject>

#include <functional>
#include <optional>

namespace codewheel {

class EncoderBus;

// The words of a device as they were on the bus, and the bits that changed in any cycle since the last frame.
struct WordsOnBus
{
    Word in = 0;
    Word out = 0;
    Word inEdges = 0;
    Word outEdges = 0;
    bool heldByJob = false;
    bool outIsKnown = true; // false: the bus does not tell it, and nobody has sent one yet
    bool inIsKnown = true;  // false: words come, and none could be believed yet

    friend bool operator==(const WordsOnBus &, const WordsOnBus &) = default;
};

// The raw face of one cyclic device, for monitors: its words, and one staged OUT word that all its monitors
// share. Staging sends nothing; write() does.
class WordChannel : public QObject
{
    Q_OBJECT

public:
    using Send = std::function<Result<void>(const WordChannel &, Word)>;

    // `send` refuses what may not go out now. The bus must outlive the channel.
    WordChannel(const EncoderBus &bus, Place number, int inWords, int outWords, Send send);

    Place place() const { return m_place; }
    int inWords() const { return m_inWords; } // 16 bit each; 0: none
    int outWords() const { return m_outWords; }

    Word in() const { return m_words.in; }
    Word out() const { return m_words.out; } // as on the bus
    Word inEdges() const { return m_words.inEdges; }
    Word outEdges() const { return m_words.outEdges; }
    bool heldByJob() const { return m_words.heldByJob; }
    bool outIsKnown() const { return m_words.outIsKnown; }
    bool inIsKnown() const { return m_words.inIsKnown; }
    const Freshness &freshness() const { return m_freshness; } // of both words
    QDateTime dateTime(Instant at) const;

    std::optional<Word> staged() const { return m_staged; } // empty: as on the bus
    Word shownOut() const { return m_staged.value_or(out()); }
    void stage(Word word); // no effect on a word of a recording
    void unstage();
    // Sends the staged word, or repeats the OUT word if none is staged. Refused (signal and return value) in
    // Watch, while the bus is stopped, while a job holds the word, and for a device without OUT; the staged
    // word stays. It is unstaged once it is on the bus; until then the bus may still refuse it (signal).
    Result<void> write() { return send(shownOut()); }
    Result<void> zero() { return send(0); } // sends 00000000, whatever is staged; refused in the same cases

    // Called by its bus: the newest frame, and that a word will be seen in the next one.
    void show(const WordsOnBus &words, const Freshness &freshness, Instant now);
    void wasWritten(Word word, Instant at) { m_written = {word, at}; }

Q_SIGNALS:
    void changed(); // in, out, edges, or whether they are live: at most once per frame
    void stagedChanged();
    void refused(const codewheel::Refusal &why);

private:
    Result<void> send(Word word);

    struct Written
    {
        Word word;
        Instant at;
    };

    const EncoderBus &m_bus;
    const Send m_send;
    Place m_place;
    int m_inWords;
    int m_outWords;
    WordsOnBus m_words;
    Freshness m_freshness;
    std::optional<Word> m_staged;
    std::optional<Written> m_written; // reported by the bus, not yet shown by a snapshot
};

} // namespace codewheel
