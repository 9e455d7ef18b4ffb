// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel {

// "20417 (4FC1h)": labels have the one or the other. Without separators, to be compared with a label by eye
// and by search.
QString serialNumberText(std::int64_t number);

} // namespace codewheel
