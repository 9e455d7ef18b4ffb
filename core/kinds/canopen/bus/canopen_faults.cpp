// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_checks.h"
#include "kinds/canopen/bus/canopen_facts.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/encoder_bits.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The translation context of these texts.
struct CanopenFaultText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenFaults)
};

Fault faultWith(Place place, Role role, const QString &word, const QString &text)
{
    return {.node = place.node, .shown = {role, word}, .text = text};
}

QString bitsText(const EncoderSession &encoder, std::uint16_t index, std::uint32_t bits)
{
    return canopen::encoderBitTexts(encoder.device(), index, bits).join(QStringLiteral(", "));
}

// What does not come may be late, or lost, where the bus is nearly full.
Fault besideLoad(Fault fault, const CanopenSnapshot &bus)
{
    if (const QString load = highLoadText(bus); !load.isEmpty())
        fault.text += u' ' + load;
    return fault;
}

Fault noLink(const CanopenSession &bus)
{
    const Refusal closed{RefusalKind::link, CanopenBusRefusalId::closed, {}};
    return {.extent = Fault::Extent::standstill,
            .shown = {Role::fault, CanopenFaultText::tr("no link")},
            .text = refusalText(bus.latest().whyLost.value_or(closed))};
}

std::optional<Fault> heardFault(const CanopenSnapshot &bus, const CanopenSnapshot::Node &heard, Place place)
{
    const QString node = place.toString();
    if (heard.isDoubled)
        return faultWith(place, Role::fault, CanopenFaultText::tr("doubled"),
                         sentence(CanopenFaultText::tr("Two devices have the number of %1. Connect one of "
                                                       "them alone, and give it another number."),
                                  {node}));
    if (heard.heartbeat == canopen::Heartbeat::lost)
        return besideLoad(
            faultWith(place, Role::fault, CanopenFaultText::tr("lost"),
                      sentence(CanopenFaultText::tr("The heartbeat of %1 does not come any more. Check its "
                                                    "supply and the wires to it."),
                               {node})),
            bus);
    if (heard.error)
        return faultWith(
            place, Role::fault, CanopenFaultText::tr("error"),
            sentence(CanopenFaultText::tr("%1 reports an error: %2."), {node, heard.error->text()}));
    return std::nullopt;
}

} // namespace

std::optional<Fault> canopenFaultOf(const CanopenSession &bus, Place place)
{
    const EncoderSession &encoder = *bus.encoder(place);
    const Reading &reading = encoder.latest();
    const QString node = place.toString();
    if (reading.state == EncoderState::silent)
        return besideLoad(faultWith(place, Role::fault, CanopenFaultText::tr("silent"),
                                    refusalText({RefusalKind::device, RefusalId::encoderSilent, {node}})),
                          bus.latest());
    if (reading.alarms.value_or(0) != 0)
        return faultWith(
            place, Role::fault, CanopenFaultText::tr("alarm"),
            sentence(CanopenFaultText::tr("%1 reports an alarm: %2. Switch it off and on; if the alarm comes "
                                          "back, replace the encoder."),
                     {node, bitsText(encoder, 0x6503, *reading.alarms)}));
    if (const auto *heard = bus.latest().heard(CanopenAddress::of(place.node).node))
        if (auto fault = heardFault(bus.latest(), *heard, place))
            return fault;
    if (reading.warnings.value_or(0) != 0)
        return faultWith(place, Role::attention, CanopenFaultText::tr("warning"),
                         sentence(CanopenFaultText::tr("%1 warns: %2. See to it before it becomes an alarm."),
                                  {node, bitsText(encoder, 0x6505, *reading.warnings)}));
    return std::nullopt;
}

std::vector<Fault> canopenFaults(const CanopenSession &bus)
{
    if (!bus.isOpen())
        return {};
    if (!bus.latest().connected)
        return {noLink(bus)};
    std::vector<Fault> faults;
    for (const Place place : bus.places())
        if (auto fault = canopenFaultOf(bus, place))
            faults.push_back(*std::move(fault));
    return faults;
}

} // namespace codewheel
