// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"
#include "catalog/ordering_key.h"

namespace codewheel {

// The member "orderingKey" of a description (docs/device-descriptions.md). Its example must itself be valid.
OrderingKey readOrderingKey(const JsonObject &json);

} // namespace codewheel
