// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/freshness.h"

#include <QString>

class QDateTime;

namespace codewheel {

// "20 s ago", "5 min ago", "2 h 5 min ago"; after a day the date and time. A time in the future is "0 s ago".
QString agoText(const QDateTime &then, const QDateTime &now);

// "24.11.2026 14:02:11", by locale: what a recording shows has a date, however short ago it was.
QString recordedText(const QDateTime &then);

// "14:02", with the date if it was not on the day of `now`, in whose time zone both are; by locale.
QString momentText(const QDateTime &at, const QDateTime &now);

// "14:02": since when something has been the same; empty for less than 10 s.
QString unchangedText(const QDateTime &since, const QDateTime &now);

// Why it is not live, as a sentence: "The bus does not run."; empty while it is live.
QString freshnessText(Freshness::Reason reason);
// In two or three words: "Bus stopped".
QString freshnessBrief(Freshness::Reason reason);

// With the date and time of then, for what is written down: "The bus does not run. Last seen: 14:02."
QString lastSeenText(Freshness::Reason reason, const QString &when);

} // namespace codewheel
