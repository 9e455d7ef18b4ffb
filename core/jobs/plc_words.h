// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/known.h"
#include "vocabulary/refusal.h"
#include "vocabulary/word.h"

#include <vector>

namespace codewheel {

// What a program of its own puts into OUT, word by word, so that an encoder takes these values and goes into
// operation with them: the handshake without what only reads, from OUT = 0 on. `known`: of the encoder, since
// it may count steps minus 1. Empty for an encoder without words; refused like the job where a value is bad.
Result<std::vector<Word>> plcWords(const DeviceDescription &device, const ParameterValues &values,
                                   const std::vector<Known> &known = {});

} // namespace codewheel
