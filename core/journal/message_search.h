// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/message_rows.h"
#include "journal/message_table.h"

#include <mutex>
#include <thread>

namespace codewheel {

// Looks through the messages for those that fit a filter, newest first, in a thread of its own: what is found
// is fetched piece by piece, so that the newest stand there at once. A text is sought in the language of the
// time.
class MessageSearch
{
public:
    // Ends the search before. From `first` to `last`, ids.
    void start(const DatabasePlace &place, const MessageFilter &filter, qint64 first, qint64 last);
    void cancel();

    struct Found
    {
        std::vector<SightedMessage> messages; // oldest first; older than all that were fetched before
        double part = 0;                      // of all that is to be looked through, 0..1
        bool done = false;
    };
    // What was found since it was asked last.
    Found take();
    bool isRunning() const { return m_isRunning; }
    // Waits for the end; for tests and the command line.
    void wait();

private:
    void run(const std::stop_token &stop, const DatabasePlace &place, const MessageFilter &filter,
             qint64 first, qint64 last);

    std::mutex m_mutex;
    Found m_found;
    bool m_isRunning = false; // of the caller: until the end was fetched
    std::jthread m_thread;
};

// The messages from `first` to `last`, ids, that fit the filter, its text included. Stops early, with
// nothing, when asked to.
Stored<std::vector<SightedMessage>> fittingMessages(const MessageTable &table, const MessageFilter &filter,
                                                    MessageTextMatcher &matcher, qint64 first, qint64 last,
                                                    const std::stop_token &stop = {});
// The same, ids alone: without a text no message is read.
Stored<std::vector<qint64>> fittingIds(const MessageTable &table, const MessageFilter &filter,
                                       MessageTextMatcher &matcher, qint64 first, qint64 last);

} // namespace codewheel
