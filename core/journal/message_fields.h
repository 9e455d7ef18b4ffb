// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

#include <QDateTime>

namespace codewheel {

// The fields of a message other than its text, in the user's language.
QString severityName(Severity severity);              // "Information", "Attention", "Fault"
QString placeName(const std::optional<Place> &place); // "1.0"; of a bus its name, or "Bus"; ""
QString nameOfNamelessBus();                          // "Bus"
QString messageTime(const QDateTime &at);             // local date, and time to the millisecond
QString messageTime(qint64 at);                       // ms since 1970, UTC

// The same in every language: "1.0", empty for a bus; "information", "attention", "fault".
QString placeText(const std::optional<Place> &place);
QString severityKey(Severity severity);
std::optional<Severity> severityFromKey(QStringView key);

} // namespace codewheel
