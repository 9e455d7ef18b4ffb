// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/line_address.h"

#include <QLocale>
#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel::structure_ids {

// What the rows of StructureModel are told apart by: a node of the ring has its index + 1, an encoder of the
// serial line its address + 1 above that of the line.
inline constexpr quintptr masterId = 0;
inline constexpr quintptr lineId = 0x100'0000;

inline quintptr encoderId(LineAddress address)
{
    return lineId + 1 + address.value;
}

inline QString positionText(std::optional<std::int64_t> position)
{
    return position ? QLocale().toString(qlonglong{*position}) : QString();
}

} // namespace codewheel::structure_ids
