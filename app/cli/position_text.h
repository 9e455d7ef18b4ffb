// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/reading.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel {

// A position in steps; where there is none, what the encoder shows instead, and what is missing.
QString positionText(std::optional<std::int64_t> position, const Reading &shown);

} // namespace codewheel
