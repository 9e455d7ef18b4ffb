// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "kinds/interbus/gateway/gateway_check.h"
#include "kinds/interbus/gateway/map_reading.h"

namespace codewheel {

// The sentences of GatewayCheck, and how it judges a word.

QString gatewayStepText(GatewayStep step, GatewaySettings::Transport transport, NodeId place);
QString foundText(const GatewaySettings &settings);
QString answeredText(int unit, Instant after);
QString readableText(int function, const RegisterBlock &block);
QString endsBeforeText(NodeId place, const RegisterBlock &its);
QString mostInReadText(int most); // registers in one request
QString closingText(std::uint64_t connections);
QString registerText(Register word); // "00E0h"

CheckOutcome wordOutcome(const DeviceRegisters &shown, const GatewaySettings &settings);
// `advises`: to change the word order where that would help.
QString wordText(const DeviceRegisters &shown, const GatewaySettings &settings, bool advises = true);

CheckOutcome mapOutcome(const MapReadings &readings, const GatewaySettings &settings);
QString mapText(const MapReadings &readings, const GatewaySettings &settings);

// The same as a step on the way of the data.
DataCheck wordCheck(const DeviceRegisters &shown, const GatewaySettings &settings);

// "fits": language-neutral.
QString plausibilityKey(Plausibility plausibility);
QString plausibilityText(Plausibility plausibility);

} // namespace codewheel
