// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc/esc_request.h"

#include <QString>

#include <optional>
#include <tl/expected.hpp>

namespace codewheel {

// A request as it is typed to be sent: "05P", "03gp5200", with spaces around it. What is wrong with it is
// told in a sentence: address, command, data, or a value outside the range of the manual's table.
// `fractionBits`: of the line, on which depends what a scaling factor may be.
tl::expected<esc::Request, QString> typedRequest(const QString &text, int fractionBits);
// The same of a request that is only read, as one to be explained: its value may be any that its digits hold.
tl::expected<esc::Request, QString> readRequest(const QString &text);

// The request that these bytes are on the wire, with ESC and CR LF; nothing for anything else.
std::optional<esc::Request> sentRequest(const QByteArray &bytes);

// "5200h = 20992"
QString bothNotations(std::uint32_t value);

} // namespace codewheel
