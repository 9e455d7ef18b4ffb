// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/rtu_frame.h"

#include <QByteArray>

namespace codewheel {

// How many frames of Modbus RTU there are among these bytes, requests and answers: of a known function, as
// long as they say, with a CRC that fits. Chance makes one among some 3 000 000 bytes of noise.
int rtuFramesIn(const QByteArray &bytes);

inline constexpr qsizetype longestRtuAnswer = 7; // to a read of one register: unit, function, count, it, CRC

// What a unit answered to a read of one register, once all of it has come.
struct RtuAnswer
{
    int exception = 0; // its code; 0: it was read
    Register value = 0;
    qsizetype begin = 0; // its place among the bytes
    qsizetype size = 0;
};
// The answer of `unit` to `function` (3 or 4) anywhere among these bytes; empty: there is none.
std::optional<RtuAnswer> rtuAnswerIn(const QByteArray &bytes, int unit, int function);

} // namespace codewheel
