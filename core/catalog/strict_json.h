// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"

namespace codewheel {

// The JSON text of a file of ours: no comments, no key twice, nothing behind the closing brace, no byte
// order mark and no NUL. What is wrong with it is reported to `faults`.
Json::Value parseStrictly(const QByteArray &json, FaultKeeper &faults);

} // namespace codewheel
