// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/monitor_display.h"

#include <array>

namespace codewheel {

namespace {

struct Flag
{
    QLatin1String key;
    bool MonitorDisplay::*value;
};

constexpr std::array allFlags{
    Flag{QLatin1String("matrix"), &MonitorDisplay::matrix},
    Flag{QLatin1String("bar"), &MonitorDisplay::bar},
    Flag{QLatin1String("decimal"), &MonitorDisplay::decimal},
    Flag{QLatin1String("signed"), &MonitorDisplay::signedDecimal},
    Flag{QLatin1String("gray"), &MonitorDisplay::gray},
    Flag{QLatin1String("binary"), &MonitorDisplay::binary},
    Flag{QLatin1String("wholeWord"), &MonitorDisplay::wholeWord},
};

} // namespace

QJsonObject MonitorDisplay::toJson() const
{
    QJsonObject json;
    for (const Flag &flag : allFlags)
        json.insert(flag.key, this->*flag.value);
    return json;
}

MonitorDisplay MonitorDisplay::fromJson(const QJsonObject &json)
{
    MonitorDisplay display;
    for (const Flag &flag : allFlags)
        display.*flag.value = json.value(flag.key).toBool(display.*flag.value);
    return display;
}

} // namespace codewheel
