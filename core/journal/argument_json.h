// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QJsonArray>

namespace codewheel {

// Arguments of messages and refusals as stored in the journal (docs/journal.md): a number as a number, a text
// as a text, {"double": 0.5}, {"word": "020000FF"}, {"parameter": "steps"}. The same in every language.
QJsonArray argumentsToJson(const std::vector<RefusalArgument> &arguments);

// What is not understood, e.g. from a newer version or a file that was tampered with, becomes a text.
std::vector<RefusalArgument> argumentsFromJson(const QJsonArray &json);

// As one line.
QString jsonLine(const QJsonArray &json);
QString jsonLine(const QJsonObject &json);

} // namespace codewheel
