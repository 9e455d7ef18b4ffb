// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_outline.h"

#include "kinds/canopen/bus/canopen_checks.h"
#include "kinds/canopen/bus/canopen_facts.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "vocabulary/sentence.h"

#include <QLocale>

namespace codewheel {
namespace {

// The translation context of these texts.
struct CanopenText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenOutline)
};

QString busTitle(const QString &link)
{
    return link.isEmpty() ? CanopenText::tr("CAN bus") : CanopenText::tr("CAN bus (%1)").arg(link);
}

QString nodeToolTip(NodeId node, const QString &called, const QString &state)
{
    return sentence(CanopenText::tr("%1  %2\nNode %3\nState: %4"),
                    {node.toString(), called, CanopenAddress::of(node).shown(), state});
}

} // namespace

const AskedOutlineWords canopenOutlineWords{
    .title = busTitle,
    .profile = profile::cia406,
    .address = [](NodeId node) { return CanopenAddress::of(node).shown(); },
    .toolTip = nodeToolTip,
};

CanopenOutline::CanopenOutline(const CanopenSession &bus)
    : AskedOutline(canopenOutlineWords, bus)
    , m_bus(bus)
{}

QString CanopenOutline::toolTip() const
{
    const CanopenFigures &figures = m_bus.latest().figures;
    return sentence(tr("%1, %2 kBit/s\nState: %3\nLoad: %4 %\nFrames: %5, errors: %6"),
                    {title(), QLocale().toString(m_bus.rate() / 1'000), state().word,
                     QLocale().toString(figures.load * 100, 'f', 0),
                     QLocale().toString(qulonglong{figures.received}),
                     QLocale().toString(qulonglong{figures.errorFrames})});
}

QString CanopenOutline::alarmStop() const
{
    return tr("jobs end, nothing that waits is sent, and the nodes that were started from here are stopped");
}

StateWord CanopenOutline::state() const
{
    if (m_bus.state() == BusState::opening)
        return connecting();
    if (!m_bus.isOpen())
        return {Role::inactive, tr("offline")};
    const CanopenSnapshot &bus = m_bus.latest();
    if (!bus.connected)
        return {Role::fault, tr("no link")};
    if (bus.scanning)
        return {Role::attention, tr("searching")};
    if (!bus.running)
        return {Role::inactive, tr("stopped")};
    return {Role::running, tr("open")};
}

std::vector<Fault> CanopenOutline::faults() const
{
    return canopenFaults(m_bus);
}

StateWord CanopenOutline::shown(Place place) const
{
    using canopen::NmtState;
    const CanopenSnapshot &bus = m_bus.latest();
    if (!m_bus.isOpen() || !bus.connected)
        return {Role::inactive, tr("cut off")};
    const EncoderSession &encoder = *m_bus.encoder(place);
    if (encoder.runningJob())
        return {Role::attention, tr("job", "it is running")};
    if (const auto fault = canopenFaultOf(m_bus, place))
        return fault->shown;
    const CanopenSnapshot::Node *heard = bus.heard(CanopenAddress::of(place.node).node);
    if (heard == nullptr)
        return {Role::inactive, tr("not seen")};
    const auto state = heard->stateOrCommanded();
    if (state == NmtState::stopped)
        return {Role::attention, tr("stopped", "a node")};
    if (state == NmtState::preOperational)
        return {Role::attention, tr("pre-operational")};
    if (heard->hasBooted)
        return {Role::attention, nodeStateText(*heard)};
    if (encoder.latest().state == EncoderState::notSeen)
        return {Role::inactive, tr("not seen")};
    return {Role::running, tr("ok")};
}

} // namespace codewheel
