// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/messages/message_model.h"

#include <QByteArray>

#include <vector>

namespace codewheel {

// Messages as CSV (RFC 4180, UTF-8): time (ISO 8601 with offset from UTC), severity, place, code, text. All
// but the text is the same in every language.
QByteArray messagesAsCsv(const std::vector<MessageRow> &rows);

} // namespace codewheel
