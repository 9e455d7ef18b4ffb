// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"

namespace codewheel {

// The JSON text of one of our files: no comments, no duplicate keys, nothing after the closing brace, no NUL.
// A byte order mark is skipped. Errors are reported to `faults`.
Json::Value parseStrictly(const QByteArray &json, FaultKeeper &faults);

} // namespace codewheel
