// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"

#include <QJsonArray>

namespace codewheel {

// Arguments of messages and refusals as the journal keeps them (docs/journal.md): a number as a number, a
// text as a text, {"double": 0.5}, {"word": "020000FF"}, {"parameter": "steps"}. In every language the same.
QJsonArray argumentsToJson(const std::vector<RefusalArgument> &arguments);

// What is not understood, as from a newer version or a file that was tampered with, becomes a text.
std::vector<RefusalArgument> argumentsFromJson(const QJsonArray &json);

// As one line.
QString jsonLine(const QJsonArray &json);
QString jsonLine(const QJsonObject &json);

} // namespace codewheel
