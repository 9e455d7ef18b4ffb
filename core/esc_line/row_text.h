// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc/esc_exchange.h"
#include "esc/esc_explain.h"

#include <QString>

namespace codewheel {

// What passed on a serial line, in text: for terminals, traces and exports.

// How control characters are shown: "␛05P␍␊", or "<1B>05P<0D><0A>" where there are no pictures of them.
enum class ControlCharacters { pictures, numbers };

// What is no ASCII is shown as <FF>.
QString controlText(const QByteArray &bytes, ControlCharacters controls = ControlCharacters::pictures);
// "1B 30 35 50 0D 0A"
QString byteText(const QByteArray &bytes);

// "sent", "answer", "echo", "garbage", "late"
QString rowKindWord(esc::LineRow::Kind kind);

// The answer that these bytes are to such a request.
std::optional<esc::Answer> answerIn(const QByteArray &bytes, esc::Command command);

// One row in words. `request`: the one sent before it, for what came in.
QString rowMeaning(const esc::LineRow &row, const std::optional<esc::Request> &request,
                   const esc::ExplainOptions &options);

} // namespace codewheel
