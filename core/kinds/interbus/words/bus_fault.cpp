// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/bus_fault.h"

#include "kinds/interbus/words/device_number.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

constexpr unsigned remoteBusInterface = 0x80;
constexpr unsigned localBusInterface = 0x81;

QString translated(const char *text)
{
    return QCoreApplication::translate("BusFault", text);
}

// Empty for a code that only the firmware's manual explains.
QString nameOf(std::uint16_t errorCode)
{
    switch (errorCode) {
    case bus_error::peripheralFault:
        return translated(QT_TRANSLATE_NOOP("BusFault", "peripheral fault"));
    case bus_error::lookingForFault:
        return translated(QT_TRANSLATE_NOOP("BusFault", "the master is looking for the fault"));
    case bus_error::nothingFound:
        return translated(QT_TRANSLATE_NOOP("BusFault",
                                            "the bus failed, but the check finds nothing: look at shielding, "
                                            "connectors and supply"));
    default:
        return {};
    }
}

std::uint16_t registerAt(const std::vector<RefusalArgument> &arguments, std::size_t index)
{
    const auto *word = index < arguments.size() ? std::get_if<Word>(&arguments[index]) : nullptr;
    return static_cast<std::uint16_t>(word ? *word : 0);
}

} // namespace

std::optional<FaultPlace> faultPlaceOf(std::uint16_t diagnosticParameter)
{
    const int segment = diagnosticParameter >> 8;
    const unsigned low = diagnosticParameter & 0xFFU;
    if (segment == 0)
        return std::nullopt;
    if (low == remoteBusInterface)
        return FaultPlace{DeviceNumber{segment, 0}.node(), FaultSpot::outgoingRemoteBus};
    if (low == localBusInterface)
        return FaultPlace{DeviceNumber{segment, 0}.node(), FaultSpot::outgoingLocalBus};
    return FaultPlace{DeviceNumber{segment, static_cast<int>(low)}.node()};
}

std::uint16_t diagnosticParameterOf(const FaultPlace &place)
{
    const DeviceNumber number = DeviceNumber::of(place.number);
    const auto low = place.spot == FaultSpot::outgoingRemoteBus  ? remoteBusInterface
                     : place.spot == FaultSpot::outgoingLocalBus ? localBusInterface
                                                                 : static_cast<unsigned>(number.position);
    return static_cast<std::uint16_t>(static_cast<unsigned>(number.segment) << 8 | low);
}

QString faultPlaceText(const FaultPlace &place)
{
    QString number = place.number.toString();
    switch (place.spot) {
    case FaultSpot::outgoingRemoteBus:
        return sentence(translated(QT_TRANSLATE_NOOP("BusFault", "outgoing remote bus of %1")), {number});
    case FaultSpot::outgoingLocalBus:
        return sentence(translated(QT_TRANSLATE_NOOP("BusFault", "outgoing local bus of %1")), {number});
    case FaultSpot::device:
        break;
    }
    return number;
}

QString busFaultText(std::uint16_t errorCode, std::uint16_t diagnosticParameter)
{
    const QString code = QStringLiteral("%1").arg(errorCode, 4, 16, QLatin1Char('0')).toUpper();
    const QString name = nameOf(errorCode);
    const auto place = faultPlaceOf(diagnosticParameter);
    const QString at = place ? faultPlaceText(*place) : QString();
    if (name.isEmpty())
        return place
                   ? sentence(translated(QT_TRANSLATE_NOOP("BusFault", "%1 at %2 (see IBS SYS FW G4 UM)")),
                              {code, at})
                   : sentence(translated(QT_TRANSLATE_NOOP("BusFault", "%1 (see IBS SYS FW G4 UM)")), {code});
    return place ? sentence(translated(QT_TRANSLATE_NOOP("BusFault", "%1 – %2 at %3")), {code, name, at})
                 : code + QStringLiteral(" – ") + name;
}

std::uint16_t diagnosticParameterOf(const std::vector<RefusalArgument> &codeAndParameter)
{
    return registerAt(codeAndParameter, 1);
}

QString busFaultText(const std::vector<RefusalArgument> &codeAndParameter)
{
    return busFaultText(registerAt(codeAndParameter, 0), diagnosticParameterOf(codeAndParameter));
}

} // namespace codewheel
