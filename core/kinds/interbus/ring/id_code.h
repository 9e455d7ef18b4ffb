// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <QString>

#include <optional>

namespace codewheel {

struct DeviceDescription;

// The 16-bit ID register of a participant: the low byte is its ID code, the high byte the length code. Data
// sheets and masters show both as the device code, "0237h".

// The ID code gives the direction of the data (bits 1..0: 01 OUT, 10 IN, 11 both, seen from the bus), except
// for bus terminals and for PCP devices, whose bits give the width of the parameter channel.
bool isPcp(unsigned idCode);

// Words of the parameter channel of a PCP device; empty if its bits do not say (10), 0 for all others.
std::optional<int> pcpWords(unsigned idCode);

// Data width of a length code in bits: bits 7..6 unit (00 word, 10 byte, 01 nibble, 11 bit), 5..0 count.
int lengthBits(unsigned lengthCode); // 0..1008

// The device that such a register describes: its words each way, no number and no make. Data narrower than a
// word take a whole one of the process image. A PCP device has data both ways; the parameter channel is part
// of the length, but not data.
RingDevice deviceOf(unsigned deviceCode);

// The kind of device an ID code stands for, in the user's language: "analog input"; empty: not known.
QString idCodeName(unsigned idCode);
// As it is described, or without a description (null) "bus terminal" or "device not known".
QString nameOrTerminal(const RingDevice &device, const DeviceDescription *description);
// As it is described, or what its ID code tells, if there is no description.
QString ringDeviceName(const RingDevice &device, const DeviceDescription *description);

// Devices with these codes are on a local bus: Loop 2 and Inline. For others the code does not say.
bool standsOnLocalBus(unsigned idCode);

} // namespace codewheel
