// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"

#include "bus/encoder_bus.h"

#include <utility>

namespace codewheel {

WordChannel::WordChannel(const EncoderBus &bus, Place number, int inWords, int outWords, Send send)
    : m_bus(bus)
    , m_send(std::move(send))
    , m_place(number)
    , m_inWords(inWords)
    , m_outWords(outWords)
{}

QDateTime WordChannel::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

void WordChannel::stage(Word word)
{
    if (m_staged == word || m_freshness.isOfRecording())
        return;
    m_staged = word;
    Q_EMIT stagedChanged();
}

void WordChannel::unstage()
{
    if (!m_staged)
        return;
    m_staged.reset();
    Q_EMIT stagedChanged();
}

Result<void> WordChannel::send(Word word)
{
    Result<void> sent = m_send(*this, word);
    if (!sent)
        Q_EMIT refused(sent.error());
    return sent;
}

void WordChannel::show(const WordsOnBus &words, const Freshness &freshness, Instant now)
{
    const bool isOther = words != m_words || !freshness.isSameStateAs(m_freshness);
    const bool isOutOther = words.out != m_words.out;
    m_words = words;
    m_freshness = freshness;
    if (m_written && m_written->at <= now) {
        const bool isStaged = m_staged == m_written->word; // not a word staged since
        m_written.reset();
        if (isStaged)
            unstage();
    }
    if (isOutOther && words.outIsKnown && m_staged == words.out) // sent by a job, or by somebody else
        unstage();
    if (isOther)
        Q_EMIT changed();
}

} // namespace codewheel
