// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_search.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr qint64 portion = 20'000;    // ids looked at together
constexpr qint64 textPortion = 4'000; // where each has to be read

} // namespace

Stored<std::vector<qint64>> fittingIds(const MessageTable &table, const MessageFilter &filter,
                                       MessageTextMatcher &matcher, qint64 first, qint64 last,
                                       const std::stop_token &stop)
{
    if (filter.text.isEmpty())
        return table.ids(first, last, filter);
    const auto messages = table.read(first, last, filter);
    if (!messages)
        return tl::unexpected(messages.error());
    std::vector<qint64> ids;
    for (const StoredMessage &message : *messages) {
        if (stop.stop_requested())
            return std::vector<qint64>();
        if (matcher.fits(message))
            ids.push_back(message.id);
    }
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
    m_found.ids.clear();
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
    const qint64 step = filter.text.isEmpty() ? portion : textPortion;
    for (qint64 end = last; table && end >= first && !stop.stop_requested(); end -= step) {
        const qint64 begin = std::max(first, end - step + 1);
        auto ids = fittingIds(*table, filter, matcher, begin, end, stop);
        if (!ids)
            break;
        const std::lock_guard lock(m_mutex);
        ids->insert(ids->end(), m_found.ids.begin(), m_found.ids.end());
        m_found.ids = std::move(*ids);
        m_found.part = static_cast<double>(last - begin + 1) / static_cast<double>(last - first + 1);
    }
    const std::lock_guard lock(m_mutex);
    m_found.done = true;
}

} // namespace codewheel
