// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"
#include "kinds/interbus/gateway/gateway_settings.h"

namespace codewheel {

// The gateway that --link names: "modbus-tcp:192.168.0.5", "modbus-tcp:[fe80::1]:1502,unit=3",
// "modbus-rtu:ttyUSB0,baud=9600". Checked before anything connects.
Checked<GatewaySettings> gatewayMeant(const LinkText &text);

// With settings as typed ("unit=3").
Checked<GatewaySettings> withSettings(GatewaySettings gateway, const QStringList &typed);

} // namespace codewheel
