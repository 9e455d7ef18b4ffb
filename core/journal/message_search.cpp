// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_search.h"

#include <algorithm>
#include <iterator>

namespace codewheel {
namespace {

constexpr qint64 portion = 4'000; // messages looked at together

} // namespace

Stored<std::vector<SightedMessage>> fittingMessages(const MessageTable &table, const MessageFilter &filter,
                                                    MessageTextMatcher &matcher, qint64 first, qint64 last,
                                                    const std::stop_token &stop)
{
    const auto messages = table.read(first, last, filter);
    if (!messages)
        return tl::unexpected(messages.error());
    std::vector<SightedMessage> fitting;
    for (const StoredMessage &message : *messages) {
        if (stop.stop_requested())
            return std::vector<SightedMessage>();
        if (matcher.fits(message))
            fitting.push_back(sighted(message));
    }
    return fitting;
}

Stored<std::vector<qint64>> fittingIds(const MessageTable &table, const MessageFilter &filter,
                                       MessageTextMatcher &matcher, qint64 first, qint64 last)
{
    if (filter.text.isEmpty())
        return table.ids(first, last, filter);
    const auto fitting = fittingMessages(table, filter, matcher, first, last);
    if (!fitting)
        return tl::unexpected(fitting.error());
    std::vector<qint64> ids;
    std::ranges::transform(*fitting, std::back_inserter(ids), &SightedMessage::id);
    return ids;
}

void MessageSearch::start(const DatabasePlace &place, const MessageFilter &filter, qint64 first, qint64 last)
{
    cancel();
    m_isRunning = true;
    m_thread = std::jthread([this, place, filter, first, last](const std::stop_token &stop) {
        run(stop, place, filter, first, last);
    });
}

void MessageSearch::cancel()
{
    m_thread = {}; // asks it to stop, and waits
    m_found = {};
    m_isRunning = false;
}

MessageSearch::Found MessageSearch::take()
{
    const std::lock_guard lock(m_mutex);
    Found found = m_found;
    m_found.messages.clear();
    m_isRunning = m_isRunning && !found.done;
    return found;
}

void MessageSearch::wait()
{
    if (m_thread.joinable())
        m_thread.join();
}

void MessageSearch::run(const std::stop_token &stop, const DatabasePlace &place, const MessageFilter &filter,
                        qint64 first, qint64 last)
{
    MessageTextMatcher matcher(filter.text);
    const auto table = MessageTable::open(place);
    for (qint64 end = last; table && end >= first && !stop.stop_requested(); end -= portion) {
        const qint64 begin = std::max(first, end - portion + 1);
        auto fitting = fittingMessages(*table, filter, matcher, begin, end, stop);
        if (!fitting)
            break;
        const std::lock_guard lock(m_mutex);
        fitting->insert(fitting->end(), m_found.messages.begin(), m_found.messages.end());
        m_found.messages = std::move(*fitting);
        m_found.part = static_cast<double>(last - begin + 1) / static_cast<double>(last - first + 1);
    }
    const std::lock_guard lock(m_mutex);
    m_found.done = true;
}

} // namespace codewheel
