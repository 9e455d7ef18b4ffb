// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "replay/recorded_rows.h"

namespace codewheel {

// Of rings: words, with what they mean to their encoders.
std::unique_ptr<RecordedRows> makeRingRows();

} // namespace codewheel
