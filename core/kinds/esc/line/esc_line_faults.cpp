// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "kinds/esc/line/esc_line_checks.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct EscLineFaultText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineFaults)
};

bool isTrouble(esc::BitId warning)
{
    return warning == esc::BitId::positionWarning || warning == esc::BitId::batteryLimit ||
           warning == esc::BitId::lightControl || warning == esc::BitId::frequencyExceeded;
}

bool isSet(std::uint16_t bits, const esc::BitRow &row)
{
    return (static_cast<unsigned>(bits) >> row.bit & 1U) != 0;
}

bool has(esc::Command command, std::uint16_t bits, esc::BitId id)
{
    return std::ranges::any_of(esc::bitsOf(command),
                               [&](const esc::BitRow &row) { return row.id == id && isSet(bits, row); });
}

// The cure for the alarm that can be dealt with by hand, otherwise for any.
QString cureOf(const Reading &reading)
{
    const std::uint16_t alarms = reading.alarms.value_or(0);
    if (has(esc::Command::alarms, alarms, esc::BitId::batteryFlat) ||
        has(esc::Command::warnings, reading.warnings.value_or(0), esc::BitId::batteryLimit))
        return EscLineFaultText::tr("Have its battery replaced, and check the position.");
    if (has(esc::Command::alarms, alarms, esc::BitId::temperatureExceeded))
        return EscLineFaultText::tr("Let it cool down, and find out what heats it.");
    return EscLineFaultText::tr("Switch it off and on; if the alarm comes back, replace the encoder.");
}

Fault noPort(const EscLineSession &line)
{
    const auto &why = line.latest().whyLost;
    return {.extent = Fault::Extent::standstill,
            .shown = line.outline().state(),
            .text =
                refusalText(why ? *why : Refusal{RefusalKind::link, RefusalId::portLost, {line.linkName()}})};
}

// They do not all fail at once by themselves: it is something they share.
Fault allSilent(const EscLineSession &line)
{
    return {.extent = Fault::Extent::standstill,
            .shown = {Role::fault, EscLineFaultText::tr("silent")},
            .text = sentence(
                EscLineFaultText::tr("No encoder answers on %1 at %2 Bd. Check the wires (A and B may be "
                                     "swapped), the supply of the encoders, and the baud rate."),
                {line.linkName(), QString::number(line.settings().baudRate)})};
}

std::optional<Fault> faultOf(const EscLineSession &line, Place place)
{
    const Reading &reading = line.encoder(place)->latest();
    Fault fault{.node = place.node};
    const QString node = place.node.toString();
    if (reading.state == EncoderState::silent) {
        fault.shown = {Role::fault, EscLineFaultText::tr("silent")};
        fault.text = refusalText({RefusalKind::device, RefusalId::encoderSilent, {node}});
    } else if (const std::uint16_t alarms = reading.alarms.value_or(0); alarms != 0) {
        fault.shown = {Role::fault, EscLineFaultText::tr("alarm")};
        const QStringList bits = esc::bitTexts(esc::Command::alarms, alarms) + troubles(reading);
        fault.text = sentence(EscLineFaultText::tr("%1 reports an alarm: %2. %3"),
                              {node, bits.join(QStringLiteral(", ")), cureOf(reading)});
    } else if (const QStringList warnings = troubles(reading); !warnings.isEmpty()) {
        fault.shown = {Role::attention, EscLineFaultText::tr("warning")};
        fault.text = sentence(EscLineFaultText::tr("%1 warns: %2. See to it before it becomes an alarm."),
                              {node, warnings.join(QStringLiteral(", "))});
    } else {
        return std::nullopt;
    }
    return fault;
}

} // namespace

QStringList troubles(const Reading &reading)
{
    QStringList texts;
    for (const esc::BitRow &row : esc::bitsOf(esc::Command::warnings))
        if (isTrouble(row.id) && isSet(reading.warnings.value_or(0), row))
            texts << esc::bitText(row.id, true);
    return texts;
}

std::vector<Fault> lineFaults(const EscLineSession &line)
{
    if (!line.isOpen())
        return {};
    if (!line.latest().connected)
        return {noPort(line)};
    const std::vector<Place> places = line.places();
    const bool noneAnswers = places.size() > 1 && std::ranges::all_of(places, [&line](Place place) {
                                 return line.encoder(place)->latest().state == EncoderState::silent;
                             });
    if (noneAnswers)
        return {allSilent(line)};
    std::vector<Fault> faults;
    for (const Place place : places)
        if (auto fault = faultOf(line, place))
            faults.push_back(*std::move(fault));
    return faults;
}

} // namespace codewheel
