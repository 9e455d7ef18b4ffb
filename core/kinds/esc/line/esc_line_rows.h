// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "replay/recorded_rows.h"

namespace codewheel {

// Of serial lines: bytes, with what they mean as ESC.
std::unique_ptr<RecordedRows> makeEscLineRows();

} // namespace codewheel
