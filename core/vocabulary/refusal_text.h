// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"
#include "vocabulary/refusal.h"

#include <QStringList>

namespace codewheel {

// Sentences in the user's language: what happened, where, and what to do.
QString refusalText(const Refusal &refusal);
QString messageText(const Message &message); // without date, time and place

// Language-neutral names for JSON: "valueOutOfRange", "alarmStop".
QString refusalKey(RefusalCode code);
QString messageKey(MessageCode code);

// For a family with sentences of its own (SentenceFamily::textOf): that of its row, with its arguments or
// with these parts; and any other pattern of its context, translated.
QString rowText(const Refusal &refusal);
QString rowText(const Refusal &refusal, const QStringList &parts);
QString rowText(const Message &message);
QString rowText(const Message &message, const QStringList &parts);
QString refusalPattern(const char *text);
QString messagePattern(const char *text);
// Of a file with a mistake, from its line and key: a file that is no JSON at all has no key.
QString brokenFileText(const Refusal &refusal);

// What the manuals call an error of the encoder, for the middle of a sentence: "wrong parameter data".
QString deviceErrorName(RefusalCode meaning);

} // namespace codewheel
