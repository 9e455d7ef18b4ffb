// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/can_log_link.h"

#include "can/can_refusals.h"

namespace codewheel {
namespace {

constexpr std::size_t mostFramesAtOnce = 64;

} // namespace

CanLogLink::CanLogLink(QString path, std::string interface)
    : m_log(std::move(path), std::move(interface))
{}

Result<void> CanLogLink::open(CanUse use)
{
    m_isOpen = false;
    if (use == CanUse::operate)
        return refuse(RefusalKind::link, CanRefusalId::onlyLogged, {name()});
    if (auto begun = m_log.begin(); !begun)
        return begun;
    m_isOpen = true;
    m_begin = m_now;
    m_first.reset();
    return {};
}

Result<void> CanLogLink::usable() const
{
    return m_isOpen ? Result<void>() : refuse(RefusalKind::link, RefusalId::lineClosed);
}

// Those that came within a moment together. Some time has to pass: what came with the opening would come
// before anybody could be there to hear it.
Result<CanNews> CanLogLink::receive(Instant until)
{
    constexpr Instant moment = std::chrono::milliseconds(1);
    if (auto checked = usable(); !checked)
        return tl::unexpected(checked.error());
    if (until <= m_begin)
        return CanNews();
    CanNews news;
    for (const CanFrame *next = m_log.next(); next != nullptr && news.frames.size() < mostFramesAtOnce;
         next = m_log.next()) {
        m_first = m_first.value_or(*next->time);
        const Instant at = m_begin + *next->time - *m_first;
        if (at > until || (!news.frames.empty() && at > *news.frames.front().time + moment))
            break;
        news.frames.push_back(*next);
        news.frames.back().time = at;
        m_log.drop();
    }
    m_now = std::max(m_now, news.frames.empty() ? until : *news.frames.back().time);
    return news;
}

Result<bool> CanLogLink::send(const CanFrame & /*frame*/)
{
    return refuse(RefusalKind::link, CanRefusalId::onlyLogged, {name()});
}

} // namespace codewheel
