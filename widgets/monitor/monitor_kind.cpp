// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/monitor_kind.h"

#include <array>

namespace codewheel {

namespace {

constexpr std::array allKinds{MonitorKind::in32, MonitorKind::out32, MonitorKind::in16};

} // namespace

QString monitorKindText(MonitorKind kind)
{
    switch (kind) {
    case MonitorKind::in32:
        break;
    case MonitorKind::out32:
        return QStringLiteral("OUT 32");
    case MonitorKind::in16:
        return QStringLiteral("IN 16");
    }
    return QStringLiteral("IN 32");
}

std::optional<MonitorKind> monitorKindFromText(QStringView text)
{
    for (const MonitorKind kind : allKinds)
        if (text == monitorKindText(kind))
            return kind;
    return {};
}

WordDirection directionOf(MonitorKind kind)
{
    return kind == MonitorKind::out32 ? WordDirection::out : WordDirection::in;
}

int bitsOf(MonitorKind kind)
{
    return kind == MonitorKind::in16 ? 16 : 32;
}

QString wordPlace(MonitorKind kind, Place number)
{
    const QString direction =
        directionOf(kind) == WordDirection::out ? QStringLiteral("OUT") : QStringLiteral("IN");
    return direction + QLatin1Char(' ') + number.shown();
}

} // namespace codewheel
