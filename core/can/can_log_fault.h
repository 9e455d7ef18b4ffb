// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel {

// Why a line of a log was not read.
enum class CanLogFault : std::uint8_t {
    notOfALog,
    badTime,
    badIdentifier,
    badData,
    wrongLength,
    tooLong,
    canFd,
    canXl,
};

QString canLogFaultText(CanLogFault fault);

} // namespace codewheel
