// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/participant.h"

#include <QString>

#include <optional>

namespace codewheel {

// The 16-bit ID register of a participant: the low byte is its ID code, the high byte the length code. Data
// sheets and masters show both as the device code, "0237h".

// The ID code tells the direction of the data (bits 1..0: 01 OUT, 10 IN, 11 both, seen from the bus), except
// for bus terminals and for PCP devices, whose bits give the width of the parameter channel.
bool isPcp(unsigned idCode);

// Words of the parameter channel of a PCP device; nothing where its bits tell none (10), 0 for all others.
std::optional<int> pcpWords(unsigned idCode);

// Data width of a length code in bits: bits 7..6 unit (00 word, 10 byte, 01 nibble, 11 bit), 5..0 count.
int lengthBits(unsigned lengthCode); // 0..1008

// The device such a register stands for: its words each way, no number and no make. Data narrower than a
// word takes a whole one of the process image. A PCP device has its data both ways; the parameter channel is
// part of the length, and no data.
Participant deviceOf(unsigned deviceCode);

// What kind of device an ID code stands for, in the user's language: "analog input"; empty: not known.
QString idCodeName(unsigned idCode);

// Devices of these codes stand on a local bus: Loop 2 and Inline. Of others the code does not tell.
bool standsOnLocalBus(unsigned idCode);

} // namespace codewheel
