// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// Sentences in the user's language: what happened, where, and what to do.
QString refusalText(const Refusal &refusal);
QString messageText(const Message &message); // without date, time and place

// Language-neutral names for JSON: "valueOutOfRange", "alarmStop".
QString refusalKey(RefusalId id);
QString messageKey(MessageId id);

} // namespace codewheel
