// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <map>
#include <vector>

namespace codewheel {

// A usual register map of gateways: what it is called, and its settings by name (gateway_settings.h);
// those it does not name have their defaults.
struct GatewayPreset
{
    QString title;
    QString sentence;
    std::map<QString, QString> registers;
};

std::vector<GatewayPreset> gatewayPresets(); // the first one: all defaults

} // namespace codewheel
