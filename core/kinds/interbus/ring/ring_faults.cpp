// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/master_look.h"
#include "kinds/interbus/ring/ring_break.h"
#include "kinds/interbus/ring/ring_checks.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_outline.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct RingFaultText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingFaults)
};

Fault standstill(const StateWord &state, const QString &text)
{
    return {.extent = Fault::Extent::standstill, .shown = state, .text = text};
}

QString cableText(const RingBreak &cable)
{
    const QString behind = cable.behind.toString();
    if (cable.behind.isEmpty())
        return sentence(RingFaultText::tr("The cable behind %1 is interrupted. Check plug and shield."),
                        {cable.before.toString()});
    return sentence(RingFaultText::tr("The cable between %1 and %2 is interrupted, or %2 has no supply. "
                                      "Check plug, shield and 24 V."),
                    {cable.before.toString(), behind});
}

// All the master says about the device is that it does not find it as expected.
QString deviceText(const RingBreak &cable)
{
    const QString before = cable.before.isEmpty() ? RingFaultText::tr("the master") : cable.before.toString();
    return sentence(RingFaultText::tr(
                        "%1 is not found as configured: it has no supply, the cable between %2 and %1 is "
                        "interrupted, or another device is there. Check 24 V, plug, and which device it is."),
                    {cable.behind.toString(), before});
}

QString notLocatedText(const MasterStatus &master)
{
    switch (master.errorCode) {
    case bus_error::lookingForFault:
        return RingFaultText::tr("The ring has failed. The master is looking for the place: wait for it.");
    case bus_error::nothingFound:
        return RingFaultText::tr("The ring has failed, but the master finds nothing any more. Check shields, "
                                 "plugs and 24 V, then start again.");
    default:
        return RingFaultText::tr("The ring has failed, and the master does not tell where. Check plugs, "
                                 "shields and 24 V, and look up its code.");
    }
}

// The first segment is the whole ring: nothing that could run would be left.
bool canRunWithout(const RingStructure &ring, NodeId node)
{
    return !node.isEmpty() && !ring.empty() &&
           DeviceNumber::of(node).segment != DeviceNumber::of(ring.front().number).segment;
}

std::vector<bool> cutOffOf(const RingSession &bus)
{
    std::vector<bool> cutOff(bus.structure().size(), false);
    const auto &devices = bus.latest().devices;
    for (std::size_t i = 0; i < std::min(cutOff.size(), devices.size()); ++i)
        cutOff[i] = !devices[i].inRing;
    return cutOff;
}

// What the cable or the device at the place of a fault may have.
QString placeText(const FaultPlace &place, const RingBreak &cable)
{
    return place.spot == FaultSpot::device ? deviceText(cable) : cableText(cable);
}

Fault busFail(const RingSession &bus)
{
    const StateWord state{Role::fault, masterStateName(MasterState::busFail)};
    const MasterStatus *master = bus.master();
    if (master == nullptr)
        return standstill(state,
                          RingFaultText::tr("The ring has failed. Look at the display of its master."));
    Fault fault = standstill(state, {});
    fault.code = master->isFaulty() ? master->faultText() : QString();
    fault.actions = {FaultAction::start};
    const auto place = master->faultPlace();
    if (!place) {
        fault.text = notLocatedText(*master);
        if (master->errorCode == bus_error::lookingForFault)
            fault.actions.clear();
        return fault;
    }
    const RingBreak cable = breakAt(bus.structure(), *place, cutOffOf(bus));
    fault.node = cable.behind.isEmpty() ? place->number : cable.behind;
    fault.cutOff = cable.behind;
    fault.text = placeText(*place, cable);
    if (canRunWithout(bus.structure(), cable.behind))
        fault.actions.push_back(FaultAction::switchOff);
    return fault;
}

// With the same place and code as a fault that stopped the ring.
Fault refusedStart(const RingSession &bus, const Refusal &why)
{
    Fault fault = standstill(bus.outline().state(), refusalText(why));
    fault.actions = {FaultAction::start};
    if (why.id == RingRefusalId::busFault)
        fault.code = busFaultText(why.arguments);
    if (const auto place = standstillPlaceOf(bus.latest())) {
        const RingBreak cable = breakAt(bus.structure(), *place, cutOffOf(bus));
        fault.node = cable.behind.isEmpty() ? place->number : cable.behind;
        fault.text = placeText(*place, cable);
    }
    fault.text.prepend(RingFaultText::tr("The ring could not be started.") + u' ');
    return fault;
}

Fault lostLink(const RingSession &bus)
{
    const QString why = bus.latest().whyLost ? refusalText(*bus.latest().whyLost) + u' ' : QString();
    const QString again = bus.latest().figures != nullptr
                              ? RingFaultText::tr("The gateway is tried again each second.")
                              : RingFaultText::tr("The program looks for the ring each second. Check the "
                                                  "cable to the master, and whether it is switched on.");
    const QString zeros =
        bus.latest().zerosAreDue
            ? u' ' + messageText({.id = RingMessageId::zerosWait}) + u' ' +
                  sentence(RingFaultText::tr("In OUT when it was last seen: %1."), {bus.outBeforeZeros()})
            : QString();
    return standstill({Role::fault, RingFaultText::tr("link lost")}, why + again + zeros);
}

// As its gateway says.
Fault toldFault(const RingSession &bus, const ToldRing &told)
{
    const QString zeros =
        bus.areZerosBeforeRing() ? u' ' + messageText({.id = RingMessageId::zerosBeforeRing}) : QString();
    Fault fault = standstill(bus.outline().state(), refusalText(told.whyItStands()) + zeros);
    if (const auto place = told.place ? faultPlaceOf(*told.place) : std::nullopt)
        fault.node = place->number;
    return fault;
}

// A word of a job, or by hand, when the link was lost or the bus stopped.
Fault leftOut(const RingSession &bus, std::size_t device)
{
    const Snapshot::Device &its = bus.latest().devices[device];
    const QString word = hexWord(*its.leftOut);
    const QString number = bus.structure()[device].number.toString();
    const QString text =
        its.outIsKnown
            ? sentence(RingFaultText::tr("%1 was left in OUT of %2. The encoder may show no position, and "
                                         "the controller gets none."),
                       {word, number})
            : sentence(RingFaultText::tr("%1 may have been left in OUT of %2, which cannot be read back. "
                                         "The encoder may show no position then."),
                       {word, number});
    return {.node = bus.structure()[device].number,
            .shown = bus.outline().state(device).shown,
            .text = text,
            .actions = {FaultAction::bringBack}};
}

Fault blockedOutputs()
{
    return {.extent = Fault::Extent::bus,
            .shown = {Role::fault, RingFaultText::tr("outputs blocked", "of a gateway")},
            .text = RingFaultText::tr(
                "The gateway did not carry out the last write (exception 4). The watchdog of its "
                "outputs may have tripped: acknowledge it, then go to Operate again."),
            .actions = {FaultAction::acknowledge}};
}

Fault lateZeros(const RingSession &bus)
{
    return {.extent = Fault::Extent::bus,
            .shown = {Role::fault, RingFaultText::tr("zeros missing", "of ALARM STOP")},
            .text = messageText({.id = RingMessageId::zerosLate, .arguments = {bus.outBeforeZeros()}})};
}

Fault peripheralFault(NodeId node)
{
    const QString number = node.toString();
    return {.extent = Fault::Extent::bus,
            .node = node,
            .shown = {Role::fault, RingFaultText::tr("periphery", "fault of it, one word")},
            .text =
                sentence(RingFaultText::tr("%1 reports a fault of its periphery, and the ring runs on. Check "
                                           "what is connected to it, and its supply; then confirm."),
                         {number}),
            .code = busFaultText(bus_error::peripheralFault, diagnosticParameterOf({.number = node})),
            .actions = {FaultAction::confirm}};
}

// The segment with the most errors; the cable before its device belongs to it.
Fault faultyCycles(const RingSession &bus, const MasterStatus &master)
{
    const auto worst = std::ranges::max_element(master.segments, {}, &MasterStatus::Segment::crcErrors);
    const NodeId device = DeviceNumber{worst->segment, 0}.node();
    const RingBreak cable = breakAt(bus.structure(), {.number = device}, cutOffOf(bus));
    const QString before = cable.before.isEmpty() ? RingFaultText::tr("the master") : cable.before.toString();
    return {.extent = Fault::Extent::bus,
            .node = device,
            .shown = {Role::attention, RingFaultText::tr("CRC errors")},
            .text = sentence(
                RingFaultText::tr("Many data cycles are faulty: %1 in segment %2. Check plugs and "
                                  "shield of the cable between %3 and %4, and what disturbs it."),
                {numberText(worst->crcErrors), QString::number(worst->segment), before, device.toString()}),
            .actions = {FaultAction::confirm}};
}

void addOfMaster(std::vector<Fault> &faults, const RingSession &bus)
{
    const MasterStatus *master = bus.master();
    if (bus.latest().state == MasterState::busFail)
        faults.push_back(busFail(bus));
    else if (bus.latest().refusedStart)
        faults.push_back(refusedStart(bus, *bus.latest().refusedStart));
    if (master == nullptr)
        return;
    for (std::size_t i = 0; i < std::min(master->devices.size(), bus.structure().size()); ++i)
        if (master->devices[i].peripheralFault)
            faults.push_back(peripheralFault(bus.structure()[i].number));
    if ((master->statusBits & diagnostic::quality) != 0 && !master->segments.empty())
        faults.push_back(faultyCycles(bus, *master));
}

} // namespace

std::vector<Fault> ringFaults(const RingSession &bus)
{
    if (bus.state() == BusState::lost)
        return {lostLink(bus)};
    std::vector<Fault> faults;
    if (bus.isOpen())
        addOfMaster(faults, bus);
    const auto &told = bus.latest().told;
    if (bus.isOpen() && bus.isRunning() && told && told->stands())
        faults.push_back(toldFault(bus, *told));
    const bool areLate = bus.isOpen() && bus.areZerosLate();
    if (bus.isOpen() && bus.latest().outputsAreBlocked) {
        faults.push_back(blockedOutputs());
        if (areLate)
            faults.back().text.prepend(lateZeros(bus).text + u' ');
    } else if (areLate) {
        faults.push_back(lateZeros(bus));
    }
    const std::size_t devices = std::min(bus.structure().size(), bus.latest().devices.size());
    for (std::size_t i = 0; bus.isOpen() && i < devices; ++i)
        if (bus.latest().devices[i].leftOut && !bus.latest().devices[i].heldByJob)
            faults.push_back(leftOut(bus, i));
    if (bus.isOpen() && bus.isRunning())
        for (std::size_t i = 0; i < bus.structure().size(); ++i)
            if (auto fault = encoderFault(bus, i))
                faults.push_back(*std::move(fault));
    return faults;
}

} // namespace codewheel
