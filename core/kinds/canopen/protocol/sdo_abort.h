// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo_transfer.h"

#include <QString>

#include <cstdint>

namespace codewheel::canopen {

// Why a transfer was aborted, as a sentence (CiA 301, table 22); empty: the code is not among them.
QString sdoAbortText(std::uint32_t code);
// The node does not have the object.
bool isMissing(const SdoOutcome &outcome);

} // namespace codewheel::canopen
