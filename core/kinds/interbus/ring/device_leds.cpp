// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/device_leds.h"

#include "catalog/device_description.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/encoder_session.h"

#include <QCoreApplication>
#include <QStringList>

namespace codewheel {

bool hasRemoteBusLeds(const EncoderSession *encoder)
{
    return encoder != nullptr && DeviceNumber::of(encoder->place().node).position == 0 &&
           encoder->device().leds;
}

QString ledLightName(LedLight state)
{
    switch (state) {
    case LedLight::on:
        return QCoreApplication::translate("Leds", "on");
    case LedLight::blinking:
        return QCoreApplication::translate("Leds", "blinking");
    case LedLight::off:
        break;
    }
    return QCoreApplication::translate("Leds", "off");
}

QString ledText(const DeviceLeds &leds)
{
    const auto text = [](const char *name, LedLight state) {
        return QString::fromLatin1(name) + u' ' + ledLightName(state);
    };
    return QStringList{text("UL", leds.ul), text("RC", leds.rc), text("BA", leds.ba), text("RBDA", leds.rbda)}
        .join(QStringLiteral(", "));
}

} // namespace codewheel
