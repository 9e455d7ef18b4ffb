// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_scaling.h"

namespace codewheel {

// The values of an encoder on a serial line: how they are put on the wire, and what they may be. Used by its
// driver, and by views that show ranges.

// The commands that read and set it; empty: none.
std::optional<esc::Command> escReadCommand(const ParameterDescription &parameter);
std::optional<esc::Command> escWriteCommand(const ParameterDescription &parameter);

// What is sent for a value: the number of a baud rate, otherwise the value itself.
std::uint32_t escData(const ParameterDescription &parameter, std::int64_t value);
// What an answer says about a value: one bit of it, or all. `swapWarningBytes`: EscSettings.
std::int64_t escValue(const ParameterDescription &parameter, std::uint32_t answer, bool swapWarningBytes);

// The description with its range narrowed by the encoder's own values: what it reported for U, M and O, or
// will be sent in the same job (`known`). While scaling is on, preset and limits lie within the measuring
// range, which applies then; that lies within the physical steps of the revolutions, as far as there is a
// scaling factor for it, which is 0.00001 to 1.0.
ParameterDescription escNarrowed(const DeviceDescription &device, Parameter parameter,
                                 const ParameterValues &known, int fractionBits = esc::defaultFractionBits);

// What the encoder sets by itself when `values` are written: with the steps per turn, its revolutions become
// the maximum (manual, GR: "Number of revolutions is 4096"). Empty if the revolutions are among the values,
// or known to be that already.
ParameterValues escSetAlong(const ParameterValues &values, const ParameterValues &known);

// The revolutions once `values` are written: those among them, those set along with them, those known, or
// those of the disc, in this order.
std::int64_t escTurnsOf(const ParameterValues &values, const ParameterValues &known);

// The scaling factor that goes with the measuring range or the steps per turn among `values` (manual, note on
// GR, GT and GF), in whatever order they are. Empty if neither is there.
std::optional<std::int64_t> escScalingFactorFor(const ParameterValues &values, const ParameterValues &known,
                                                int fractionBits);

// The addresses an encoder may have after X was sent with two digits that the manual reads in two ways:
// hexadecimal first, then, if it differs, decimal.
std::vector<EscLineAddress> escReadingsOf(EscLineAddress sent);

} // namespace codewheel
