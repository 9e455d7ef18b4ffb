// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/slcan_link.h"

#include "can/can_refusals.h"

#include <algorithm>

namespace codewheel {

SlcanLink::SlcanLink(std::unique_ptr<ByteLink> line, int rate, int baudRate)
    : m_line(std::move(line))
    , m_rate(rate)
    , m_baudRate(baudRate)
    , m_talk(m_line->name(), m_rate)
{}

SlcanLink::~SlcanLink()
{
    close();
}

// A line that is open remains so: opening it may reset the board.
Result<void> SlcanLink::open(CanUse use)
{
    const bool isNew = !m_isOpen;
    m_loss.reset();
    if (isNew) {
        if (auto opened = openLine(); !opened)
            return opened;
        m_talk = SlcanConversation(name(), m_rate); // which may be plugged in elsewhere
        m_interface = name().section(u'/', -1).toStdString();
    }
    const bool wasBegun = !isNew && m_talk.state() == SlcanConversation::State::opening && use == m_use;
    m_use = use;
    if (!wasBegun)
        m_talk.open(use, m_takesUnsureWatch, isNew, now());
    while (m_talk.state() == SlcanConversation::State::opening) {
        const Result<bool> went = proceed(m_talk.wakesAt().value_or(now()));
        if (!went)
            return tl::unexpected(went.error());
        if (!*went)
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
    }
    if (auto written = write(); !written)
        return written;
    if (m_talk.state() != SlcanConversation::State::failed)
        return {};
    const Refusal why = m_talk.failure();
    close();
    return tl::unexpected(why);
}

Result<void> SlcanLink::openLine()
{
    auto opened =
        m_line->open({.baudRate = m_baudRate, .parity = SerialSettings::Parity::none, .stopBits = 1});
    m_isOpen = opened.has_value();
    return opened;
}

// The adapter, too: it would go on acknowledging, or repeat for ever what nobody acknowledges.
void SlcanLink::close()
{
    if (std::exchange(m_isOpen, false)) {
        [[maybe_unused]] const auto closed = m_line->write(m_talk.close());
        m_line->close();
    }
}

Result<void> SlcanLink::write()
{
    const QByteArray bytes = m_talk.next(now());
    if (bytes.isEmpty())
        return {};
    auto written = m_line->write(bytes);
    if (!written)
        close();
    return written;
}

Result<bool> SlcanLink::proceed(Instant until)
{
    if (const auto written = write(); !written)
        return tl::unexpected(written.error());
    const Instant end = std::min(until, m_talk.wakesAt().value_or(until));
    const Result<QByteArray> bytes = m_line->read(end);
    if (!bytes) {
        close();
        return tl::unexpected(bytes.error());
    }
    m_talk.received(*bytes, now());
    return !bytes->isEmpty() || now() >= end;
}

// What comes in meanwhile is kept.
void SlcanLink::wait(Instant until)
{
    if (!m_isOpen)
        m_line->wait(until);
    while (m_isOpen && now() < until) {
        const Result<bool> went = proceed(until);
        if (!went)
            m_loss = went.error();
        else if (!*went)
            return;
    }
}

Result<CanNews> SlcanLink::receive(Instant until)
{
    if (const auto loss = std::exchange(m_loss, std::nullopt))
        return tl::unexpected(*loss);
    if (!m_isOpen)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    CanNews news = takeNews(); // of what was sent
    while (news.frames.empty() && news.fates.empty()) {
        const Result<bool> went = proceed(until);
        if (!went)
            return tl::unexpected(went.error());
        news = takeNews();
        if (m_talk.state() == SlcanConversation::State::failed) { // a board that started anew
            const Refusal why = m_talk.failure();
            close();
            return tl::unexpected(why);
        }
        if (!*went || now() >= until)
            break;
    }
    if (const auto written = write(); !written)
        return tl::unexpected(written.error());
    return news;
}

CanNews SlcanLink::takeNews()
{
    CanNews news = m_talk.takeNews();
    for (CanFrame &frame : news.frames)
        frame.interface = m_interface;
    return news;
}

Result<bool> SlcanLink::send(const CanFrame &frame)
{
    if (!m_isOpen)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    if (m_use == CanUse::watch)
        return refuse(RefusalKind::link, CanRefusalId::onlyWatches, {name()});
    if (!m_talk.send(frame, now()))
        return false;
    return write().map([] { return true; });
}

std::optional<Refusal> SlcanLink::remark() const
{
    return m_talk.mayRunAt750()
               ? std::optional(Refusal{RefusalKind::link, CanRefusalId::rateMayBe750, {name()}})
               : std::nullopt;
}

} // namespace codewheel
