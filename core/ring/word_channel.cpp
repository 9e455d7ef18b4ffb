// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/word_channel.h"

#include "ring/bus_session.h"

#include <tuple>

namespace codewheel {

WordChannel::WordChannel(BusSession &bus, std::size_t device, DeviceNumber number, int inWords, int outWords)
    : m_bus(bus)
    , m_device(device)
    , m_number(number)
    , m_inWords(inWords)
    , m_outWords(outWords)
{}

QDateTime WordChannel::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

void WordChannel::stage(Word word)
{
    if (m_staged == word)
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

Result<void> WordChannel::write()
{
    const bool isInRing = m_bus.channel(m_number) == this; // else at its place may be another by now
    Result<void> sent =
        isInRing ? m_bus.write(m_device, shownOut())
                 : Result<void>(refuse(RefusalKind::link, RefusalId::notInRing, {m_number.toString()}));
    if (!sent)
        Q_EMIT refused(sent.error());
    return sent;
}

void WordChannel::wasWritten(Word word, Instant at)
{
    m_written = {word, at};
}

void WordChannel::show(const Snapshot &ring, const Freshness::Circumstances &bus)
{
    const auto shown = [this] {
        return std::tuple(m_in, m_out, m_inEdges, m_outEdges, m_heldByJob, m_freshness.state(),
                          m_freshness.reason());
    };
    const auto before = shown();
    const Snapshot::Device &device = ring.devices[m_device];
    m_freshness = {ring.cycle > 0 ? std::optional(device.reading.at) : std::nullopt, bus};
    m_in = device.in;
    m_out = device.out;
    m_inEdges = device.inEdges;
    m_outEdges = device.outEdges;
    m_heldByJob = device.heldByJob;

    if (m_written && m_written->at <= ring.at) {
        // Not a word staged meanwhile.
        const bool isStaged = m_staged == m_written->word;
        m_written.reset();
        if (isStaged)
            unstage();
    }
    if (shown() != before)
        Q_EMIT changed();
}

} // namespace codewheel
