// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/message_rows.h"
#include "journal/message_table.h"

#include <mutex>
#include <thread>

namespace codewheel {

// Searches the messages for those that match a filter, newest first, in a thread of its own: results are
// fetched piece by piece, so that the newest are there at once. A text is searched in the current language.
class MessageSearch
{
public:
    // Ends the previous search. From `first` to `last`, ids.
    void start(const DatabasePlace &place, const MessageFilter &filter, qint64 first, qint64 last);
    void cancel();

    struct Found
    {
        std::vector<SightedMessage> messages; // oldest first; older than all that were fetched before
        double part = 0;                      // of everything to be searched, 0..1
        bool done = false;
    };
    // What was found since the last call.
    Found take();
    bool isRunning() const { return m_isRunning; }
    // Waits for the end; for tests and the command line.
    void wait();

private:
    void run(const std::stop_token &stop, const DatabasePlace &place, const MessageFilter &filter,
             qint64 first, qint64 last);

    std::mutex m_mutex;
    Found m_found;
    bool m_isRunning = false; // for the caller: until the end was fetched
    std::jthread m_thread;
};

// The messages from `first` to `last`, ids, that match the filter, its text included. Stops early, empty,
// when asked to.
Stored<std::vector<SightedMessage>> fittingMessages(const MessageTable &table, const MessageFilter &filter,
                                                    MessageTextMatcher &matcher, qint64 first, qint64 last,
                                                    const std::stop_token &stop = {});
// The same, only the ids: without a text no message is read.
Stored<std::vector<qint64>> fittingIds(const MessageTable &table, const MessageFilter &filter,
                                       MessageTextMatcher &matcher, qint64 first, qint64 last);

} // namespace codewheel
