// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel::canopen {

// Why a transfer was aborted, as a sentence (CiA 301, table 22); empty: the code is not among them.
QString sdoAbortText(std::uint32_t code);

} // namespace codewheel::canopen
