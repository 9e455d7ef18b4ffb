// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

#include <QDateTime>

namespace codewheel {

// A message as stored in the journal (docs/journal.md). The code is a text, so that one of a newer version is
// kept and shown as well.
struct StoredMessage
{
    qint64 id = 0; // rises with each message
    qint64 at = 0; // ms since 1970, UTC
    Severity severity = Severity::information;
    std::optional<Place> place{};
    QString code;
    QString arguments; // JSON array
    QString refusal{}; // JSON object; empty: none

    friend bool operator==(const StoredMessage &, const StoredMessage &) = default;
};

StoredMessage storedMessage(const Message &message, const QDateTime &at);

// The message, if this version knows its code (and the code of what was refused).
std::optional<Message> messageOf(const StoredMessage &stored);

// The sentence in the user's language; for an unknown code, the code and its arguments.
QString messageText(const StoredMessage &stored);

// The code of what was refused says more than "refused".
QString codeOf(const StoredMessage &stored);

} // namespace codewheel
