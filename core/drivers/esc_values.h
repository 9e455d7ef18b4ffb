// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/line_address.h"
#include "esc/esc_scaling.h"

namespace codewheel {

// The values of an encoder on a serial line: how they stand on the wire, and what they may be. Used by its
// driver, and by views that show ranges.

// The commands that tell and set it; nothing: none.
std::optional<esc::Command> escReadCommand(const ParameterDescription &parameter);
std::optional<esc::Command> escWriteCommand(const ParameterDescription &parameter);

// What is sent for a value: the number of a baud rate, else the value itself.
std::uint32_t escData(const ParameterDescription &parameter, std::int64_t value);
// What an answer says of a value: a bit of it, or all. `swapWarningBytes`: EscSettings.
std::int64_t escValue(const ParameterDescription &parameter, std::uint32_t answer, bool swapWarningBytes);

// The description with the range that the encoder's own values leave: what it told by U, M and O, or will be
// told in the same job (`known`). While the scaling is on, preset and limits lie within the measuring range,
// which holds then; that lies within the physical steps of the revolutions, so far that there is a scaling
// factor for it, which is 0.00001 to 1.0.
ParameterDescription escNarrowed(const DeviceDescription &device, Parameter parameter,
                                 const ParameterValues &known, int fractionBits = esc::defaultFractionBits);

// What the encoder sets by itself as `values` are written: with the steps per turn, its revolutions become
// all it has (manual, GR: "Number of revolutions is 4096"). Empty where the revolutions are among the values,
// or known to be so.
ParameterValues escSetAlong(const ParameterValues &values, const ParameterValues &known);

// The revolutions once `values` are written: among them, else set along with them, else those known, else
// those of the disc.
std::int64_t escTurnsOf(const ParameterValues &values, const ParameterValues &known);

// The scaling factor that goes with the measuring range or the steps per turn among `values` (manual, note on
// GR, GT and GF), in whatever order they are. Nothing where neither is there.
std::optional<std::int64_t> escScalingFactorFor(const ParameterValues &values, const ParameterValues &known,
                                                int fractionBits);

// What an encoder may have as its address after X was sent with two digits that the manual gives two
// readings: hexadecimal first, then, where it is another address, decimal.
std::vector<LineAddress> escReadingsOf(LineAddress sent);

} // namespace codewheel
