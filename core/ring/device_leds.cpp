// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/device_leds.h"

#include <QCoreApplication>
#include <QStringList>

namespace codewheel {

QString ledStateName(LedState state)
{
    switch (state) {
    case LedState::on:
        return QCoreApplication::translate("Leds", "on");
    case LedState::blinking:
        return QCoreApplication::translate("Leds", "blinking");
    case LedState::off:
        break;
    }
    return QCoreApplication::translate("Leds", "off");
}

QString ledText(const DeviceLeds &leds)
{
    const auto text = [](const char *name, LedState state) {
        return QString::fromLatin1(name) + u' ' + ledStateName(state);
    };
    return QStringList{text("UL", leds.ul), text("RC", leds.rc), text("BA", leds.ba), text("RBDA", leds.rbda)}
        .join(QStringLiteral(", "));
}

} // namespace codewheel
