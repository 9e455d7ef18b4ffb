// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"
#include "doctor/doctor_texts.h"
#include "doctor/link_hindrances.h"
#include "links/can_interface.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

constexpr int proposedBitRate = 125'000;

Hindrance switchedOff(const QString &name, const QString &command)
{
    return {HindranceId::canDown, Hindrance::Weight::prevents, name,
            sentence(DoctorTexts::tr("The CAN interface %1 is switched off. Switch it on with the bit rate "
                                     "of the bus."),
                     {name}),
            command};
}

} // namespace

Hindrances canHindrances(const Computer &computer)
{
    Hindrances found;
    for (const CanInterface &interface : canInterfaces(computer, {}))
        if (!interface.isUp)
            found.push_back(switchedOff(interface.name, switchOnCommand(interface, proposedBitRate)));
    return found;
}

std::optional<Hindrance> canHindranceOf(const Refusal &why)
{
    const auto id = why.id.as<CanRefusalId>();
    if (!id)
        return std::nullopt;
    const QStringList parts = argumentTexts(why.arguments);
    const auto asRefused = [&](HindranceId hindrance, const QString &command) {
        return Hindrance{hindrance, Hindrance::Weight::prevents, parts.value(0), refusalText(why), command};
    };
    switch (*id) {
    case CanRefusalId::interfaceDown:
        return switchedOff(parts.value(0), parts.value(1));
    case CanRefusalId::interfaceMissing:
        return asRefused(HindranceId::canMissing, QStringLiteral("ip link"));
    case CanRefusalId::notInKernel:
        return asRefused(HindranceId::noCan, QStringLiteral("sudo modprobe can_raw"));
    case CanRefusalId::pluginMissing:
        return asRefused(HindranceId::noCanPlugin, QStringLiteral("sudo apt install libqt6serialbus6"));
    default:
        return std::nullopt;
    }
}

} // namespace codewheel
