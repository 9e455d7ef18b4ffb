// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel {

// Why a line of a log was not read, or only in part.
enum class CanLogFault : std::uint8_t {
    notOfALog,
    badTime,
    badIdentifier,
    badData,
    wrongLength,
    tooLong,
    canFd,
    canXl,
    badDirection,
    badDate,
    otherTime, // its frame was read
};

QString canLogFaultText(CanLogFault fault);

} // namespace codewheel
