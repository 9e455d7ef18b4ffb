// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/stored_message.h"

#include <functional>

namespace codewheel {

// Which messages are wanted: of this severity or worse, of one place or bus, of a period, with this text
// somewhere in the row as shown.
struct MessageFilter
{
    struct Where
    {
        bool all = true;
        // For a bus itself: all of that bus, its devices included. Empty: of no device.
        std::optional<Place> at = {};

        friend bool operator==(const Where &, const Where &) = default;
    };

    Severity least = Severity::information;
    Where place{};
    std::optional<qint64> from{};  // ms since 1970, UTC; included
    std::optional<qint64> until{}; // not included
    QString text{};                // case does not matter

    bool isEmpty() const { return *this == MessageFilter(); }

    friend bool operator==(const MessageFilter &, const MessageFilter &) = default;
};

// Whether a message matches a text, in the language current when it is made. Remembers earlier answers, since
// most messages recur; used by one thread.
class MessageTextMatcher
{
public:
    explicit MessageTextMatcher(QString text);

    bool fits(const StoredMessage &message);

private:
    bool fitsTime(qint64 at);
    bool fitsText(const StoredMessage &message);

    QString m_text;
    QHash<QString, bool> m_texts; // by code and arguments
    qint64 m_quarter = -1;        // the quarter of an hour that m_date is for
    QString m_date;               // as shown in that quarter
    QString m_whichHour;          // of two, where the clocks are put back
    qint64 m_offset = 0;          // of local time from UTC in that quarter, ms
};

} // namespace codewheel
