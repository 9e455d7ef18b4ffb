// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/k3_word.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel {

// A position in steps; where the coding is not known, the raw word and what is missing.
QString positionText(std::optional<std::int64_t> position, Word in);

} // namespace codewheel
