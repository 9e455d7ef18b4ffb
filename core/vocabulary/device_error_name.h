// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel {

// What the manuals call an error of the encoder, for the middle of a sentence: "wrong parameter data".
QString deviceErrorName(RefusalCode meaning);

} // namespace codewheel
