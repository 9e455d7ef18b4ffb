// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_outline.h"

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/interbus/ring/device_leds.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/master_look.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_checks.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/ring_tree.h"
#include "vocabulary/encoder_session.h"

#include <algorithm>

namespace codewheel {
namespace {

// The translation context of these texts.
struct RingText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingOutline)
};

QString idCodeText(unsigned code)
{
    return QStringLiteral("%1 = %2").arg(hexCode(code, 2)).arg(code);
}

// Nobody named the device, and several in the catalog could be it.
bool makeIsOpen(const RingDevice &participant, const Catalog &catalog)
{
    return participant.deviceKey.isEmpty() &&
           std::ranges::any_of(catalog.devices(), [&](const DeviceDescription &device) {
               return !device.isGeneric() && device.deviceCode == participant.deviceCode;
           });
}

BusNode nodeOf(const RingDevice &participant, const DeviceDescription *device, const Catalog &catalog)
{
    return {.node = participant.number,
            .parent = {},
            .isCoupler = participant.idCode() == busTerminalIdCode,
            .name = ringDeviceName(participant, device),
            .profile = device ? profileName(device->profile) : QStringLiteral("-"),
            .code = idCodeText(participant.idCode()),
            .words = QStringLiteral("%1 / %2").arg(participant.inWords).arg(participant.outWords),
            .deviceCode = participant.deviceCode,
            .makeIsOpen = makeIsOpen(participant, catalog)};
}

template <typename DescriptionOf>
std::vector<BusNode> nodesOf(const RingStructure &ring, const Catalog &catalog, DescriptionOf descriptionOf)
{
    const RingTree tree = ringTree(ring);
    std::vector<BusNode> nodes;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        nodes.push_back(nodeOf(ring[i], descriptionOf(ring[i]), catalog));
        nodes.back().parent = tree.nodes[i].parent;
    }
    return nodes;
}

QString toolTipOf(const RingDevice &participant, const QString &called, const QString &state)
{
    return RingText::tr("%1  %2\nID code %3, device code %4\nWords: IN %5, OUT %6\nState: %7")
        .arg(participant.number.toString(), called, idCodeText(participant.idCode()),
             hexCode(participant.deviceCode, 4))
        .arg(participant.inWords)
        .arg(participant.outWords)
        .arg(state);
}

QString masterTitle()
{
    return RingText::tr("Master");
}

QString masterToolTip(const StateWord &state)
{
    return RingText::tr("The master of the ring is in the state %1.").arg(state.word);
}

} // namespace

bool RingOutline::isBehindGateway() const
{
    return m_bus.latest().figures != nullptr;
}

QString RingOutline::title() const
{
    return isBehindGateway() ? tr("Gateway") : masterTitle();
}

std::optional<QString> RingOutline::behindName() const
{
    return isBehindGateway() ? tr("gateway", "behind the name of a ring") : QString();
}

QString RingOutline::toolTip() const
{
    if (isBehindGateway())
        return m_bus.latest().told
                   ? tr("The gateway to the ring: %1.").arg(state().word)
                   : tr("The gateway to the ring: %1. It does not tell the state of the master.")
                         .arg(state().word);
    return masterToolTip(state());
}

StateWord RingOutline::state() const
{
    if (m_bus.state() == BusState::opening)
        return connecting();
    if (m_bus.state() == BusState::lost)
        return {Role::fault, tr("link lost")};
    if (!m_bus.isOpen())
        return offline();
    const auto &told = m_bus.latest().told;
    if (m_bus.isRunning() && told && told->stands())
        return {Role::fault, told->hasFailed ? tr("ring failed") : tr("ring stands still")};
    if (m_bus.latest().outputsAreBlocked)
        return {Role::fault, tr("outputs blocked", "of a gateway")};
    if (isBehindGateway())
        return m_bus.isRunning() ? StateWord{Role::running, tr("connected")}
                                 : StateWord{Role::inactive, tr("stopped")};
    return {masterRole(m_bus.latest()), masterStateName(m_bus.latest().state)};
}

std::vector<BusNode> RingOutline::nodes() const
{
    return nodesOf(m_bus.structure(), m_bus.catalog(), [this](const RingDevice &participant) {
        const EncoderSession *encoder = m_bus.encoder(participant.number);
        return encoder == nullptr ? nullptr : &encoder->device();
    });
}

NodeState RingOutline::state(std::size_t node) const
{
    if (node >= m_bus.structure().size()) // another ring was read in
        return {};
    NodeState state{.shown = shown(node), .position = {}, .isOld = false};
    const EncoderSession *encoder = m_bus.encoder(m_bus.structure()[node].number);
    state.isOld = encoder != nullptr && encoder->freshness().isOld();
    if (node >= m_bus.latest().devices.size())
        return state;
    const Snapshot::Device &device = m_bus.latest().devices[node];
    state.position = device.reading.position;
    state.velocity = device.reading.velocity;
    state.isCutOff = m_bus.isOpen() && !device.inRing && !m_bus.latest().isUnsettled(node);
    state.isBehindBreak = state.isCutOff && isBehindBreak(node);
    return state;
}

StateWord RingOutline::shown(std::size_t node) const
{
    if (node >= m_bus.latest().devices.size())
        return {Role::inactive, tr("not seen")};
    const NodeId number = m_bus.structure()[node].number;
    const Snapshot::Device &device = m_bus.latest().devices[node];
    const WordChannel *channel = m_bus.channel(number);
    if (auto fault = faultOf(node))
        return *fault;
    if (m_bus.isRunning() && m_bus.latest().isUnsettled(node))
        return {Role::attention, tr("unsettled", "no two reads of its word agree")};
    if (!device.inRing)
        return {Role::inactive, isSwitchedOff(node) ? tr("off", "switched off") : tr("cut off")};
    if (!m_bus.isRunning())
        return {Role::inactive, tr("stopped")};
    const bool exchanged = m_bus.latest().cycle > 0;
    if (exchanged && m_bus.encoder(number) == nullptr) // no driver that could say more
        return {Role::running, tr("ok")};
    if (const auto fault = encoderFault(m_bus, node))
        return fault->shown;
    if (device.leftOut)
        return {Role::attention, tr("OUT left", "a word that a job has left in OUT")};
    if (device.heldByJob)
        return {Role::attention, tr("job", "it is running")};
    if (channel != nullptr && channel->staged())
        return {Role::attention, tr("unsent", "a staged word")};
    switch (device.reading.state) {
    case EncoderState::parameterization:
        return {Role::attention, tr("parameters", "parameterization")};
    case EncoderState::readOut:
        return {Role::attention, tr("read-out")};
    case EncoderState::service:
        return {Role::attention, tr("service", "service mode")};
    case EncoderState::silent:
        return {Role::fault, tr("silent")};
    case EncoderState::unknown:
        return {Role::attention, tr("unknown", "state")};
    case EncoderState::notSeen:
        return {Role::inactive, tr("not seen")};
    case EncoderState::operation:
    case EncoderState::error:
    case EncoderState::waiting: // no encoder of a ring does
        break;
    }
    const Reading &its = device.reading;
    if (exchanged && !its.position && !its.velocity && !its.cams) // its mode or coding is not known
        return {Role::attention, tr("no position")};
    return {Role::running, tr("ok")};
}

// What the master says about this very device.
std::optional<StateWord> RingOutline::faultOf(std::size_t node) const
{
    const MasterStatus *master = m_bus.master();
    if (master == nullptr)
        return std::nullopt;
    const NodeId number = m_bus.structure()[node].number;
    const auto at = standstillPlaceOf(m_bus.latest());
    if (node < master->devices.size() && master->devices[node].peripheralFault)
        return StateWord{Role::fault, tr("periphery", "fault of it")};
    if (at && at->number == number)
        return StateWord{Role::fault, tr("fault")};
    return std::nullopt;
}

bool RingOutline::isSwitchedOff(std::size_t node) const
{
    const MasterStatus *master = m_bus.master();
    return master != nullptr &&
           std::ranges::any_of(master->segments, [&](const MasterStatus::Segment &segment) {
               return segment.switchedOff &&
                      std::ranges::count(placesBehindSegment(m_bus.structure(), segment.segment), node) > 0;
           });
}

// The first one that a fault cuts off.
bool RingOutline::isBehindBreak(std::size_t node) const
{
    const bool isFault = m_bus.latest().connected && m_bus.latest().state == MasterState::busFail;
    if (!isFault || isSwitchedOff(node))
        return false;
    for (std::size_t i = 0; i < node; ++i)
        if (!m_bus.latest().devices[i].inRing && !isSwitchedOff(i))
            return false;
    return true;
}

std::vector<Fault> RingOutline::faults() const
{
    return ringFaults(m_bus);
}

// What is wrong with this very device, in full.
QString RingOutline::faultText(std::size_t node) const
{
    const std::vector<Fault> all = faults();
    const auto its = std::ranges::find(all, m_bus.structure()[node].number, &Fault::node);
    return its == all.end() ? QString() : its->text;
}

// How the position is coded in IN, if it is not plain binary.
QString RingOutline::codingText(const RingDevice &participant) const
{
    const EncoderSession *encoder = m_bus.encoder(participant.number);
    const auto coding = encoder == nullptr ? std::nullopt : encoder->latest().coding;
    if (coding == PositionCoding::gray)
        return tr("Position: Gray code");
    if (coding == PositionCoding::signedBinary)
        return tr("Position: signed");
    return {};
}

// On the housing, as they should be, where the state of the ring is known from its master.
QString RingOutline::ledsText(std::size_t node) const
{
    const Snapshot &ring = m_bus.latest();
    if (!ring.connected || isBehindGateway() || node >= ring.devices.size() ||
        !hasRemoteBusLeds(m_bus.encoder(m_bus.structure()[node].number)))
        return {};
    return tr("LEDs: %1").arg(ledText(ledsOf(ring.state, ring.devices[node].inRing)));
}

QString RingOutline::toolTip(std::size_t node, const QString &called) const
{
    if (node >= m_bus.structure().size())
        return {};
    const RingDevice &participant = m_bus.structure()[node];
    QStringList lines{toolTipOf(participant, called, shown(node).word), faultText(node), ledsText(node),
                      codingText(participant)};
    lines.removeAll(QString());
    return lines.join(u'\n');
}

QString PlannedRingOutline::title() const
{
    return masterTitle();
}

QString PlannedRingOutline::toolTip() const
{
    return masterToolTip(state());
}

std::vector<BusNode> PlannedRingOutline::nodes() const
{
    return nodesOf(m_structure, m_catalog, [this](const RingDevice &participant) {
        return m_catalog.find(participant.deviceKey, participant.deviceCode);
    });
}

QString PlannedRingOutline::toolTip(std::size_t node, const QString &called) const
{
    return toolTipOf(m_structure[node], called, planned().word);
}

} // namespace codewheel
