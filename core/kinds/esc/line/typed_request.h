// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_request.h"

#include <QString>

#include <optional>
#include <tl/expected.hpp>

namespace codewheel {

// A request as typed to be sent: "05P", "03gp5200", with spaces around it. What is wrong with it is explained
// in a sentence: address, command, data, or a value outside the range of the manual's table. `fractionBits`:
// of the line; the range of a scaling factor depends on it.
tl::expected<esc::Request, QString> typedRequest(const QString &text, int fractionBits);
// The same for a request that is only read, e.g. to be explained: its value may be any that fits its digits.
tl::expected<esc::Request, QString> readRequest(const QString &text);

// The request that these bytes are on the wire, with ESC and CR LF; empty for anything else.
std::optional<esc::Request> sentRequest(const QByteArray &bytes);

// "5200h = 20992"
QString bothNotations(std::uint32_t value);

} // namespace codewheel
