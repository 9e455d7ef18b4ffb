// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc/esc_request.h"

#include <QString>

#include <optional>
#include <tl/expected.hpp>

namespace codewheel {

// A request as it is typed: "05P", "03gp5200", with spaces around it. What is wrong with it is told in a
// sentence: address, command, data, or a value outside the range of the manual's table.
tl::expected<esc::Request, QString> typedRequest(const QString &text);

// The request that these bytes are on the wire, with ESC and CR LF; nothing for anything else.
std::optional<esc::Request> sentRequest(const QByteArray &bytes);

// "5200h = 20992"
QString bothNotations(std::uint32_t value);

} // namespace codewheel
