// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"

#include <QString>

#include <vector>

namespace codewheel {

// A setting of a gateway as a field of its form. Its values are the texts of gateway_settings.h.
struct SettingField
{
    struct Choice
    {
        QString value;
        QString text;
    };

    QString name; // of the setting
    QString label;
    QString sentence; // what it is for
    gateway_limits::Limits limits{};
    QString unit{};                // " ms"
    QString none{};                // text for "none", one below the least number; empty: always a number
    std::vector<Choice> choices{}; // instead of a number
    bool isText = false;           // likewise
};

std::vector<SettingField> settingFields(GatewaySettings::Transport transport);

} // namespace codewheel
