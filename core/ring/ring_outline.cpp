// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/ring_outline.h"

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "encoder/device_error_name.h"
#include "encoder/encoder_session.h"
#include "ring/device_leds.h"
#include "ring/master_look.h"
#include "ring/ring_session.h"
#include "ring/ring_tree.h"

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct RingText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingOutline)
};

QString idCodeText(unsigned code)
{
    return QStringLiteral("%1 = %2").arg(hexCode(code, 2)).arg(code);
}

// By its number, as the manual's table has it; 0 is none of them. An LA-66 has but one error, and names it.
QString errorText(const EncoderSession *encoder, const Reading &reading)
{
    const unsigned number = reading.errorNumber.value_or(0);
    const DeviceError *error = encoder == nullptr ? nullptr : encoder->device().findError(number);
    if (error != nullptr && encoder->device().profile == Profile::la66)
        return deviceErrorName(error->meaning);
    if (number == 0)
        return deviceErrorName(RefusalId::noValidPosition);
    return RingText::tr("error %1").arg(number);
}

// Nobody named the device, and the catalog has some that it could be.
bool makeIsOpen(const Participant &participant, const Catalog &catalog)
{
    return participant.deviceKey.isEmpty() &&
           std::ranges::any_of(catalog.devices(), [&](const DeviceDescription &device) {
               return !device.isGeneric() && device.deviceCode == participant.deviceCode;
           });
}

BusNode nodeOf(const Participant &participant, const DeviceDescription *device, const Catalog &catalog)
{
    return {.node = participant.number,
            .parent = {},
            .isCoupler = participant.idCode == busTerminalIdCode,
            .name = participantName(participant, device),
            .profile = device ? profileName(device->profile) : QStringLiteral("-"),
            .code = idCodeText(participant.idCode),
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

QString toolTipOf(const Participant &participant, const QString &called, const QString &state)
{
    return RingText::tr("%1  %2\nID code %3, device code %4\nWords: IN %5, OUT %6\nState: %7")
        .arg(participant.number.toString(), called, idCodeText(participant.idCode),
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

QString RingOutline::title() const
{
    return masterTitle();
}

QString RingOutline::toolTip() const
{
    return masterToolTip(state());
}

QString RingOutline::alarmStop() const
{
    return tr("all OUT words become 0, and jobs end");
}

StateWord RingOutline::state() const
{
    if (m_bus.state() == BusState::opening)
        return connecting();
    if (m_bus.state() == BusState::lost)
        return {Role::fault, tr("link lost")};
    if (!m_bus.isOpen())
        return offline();
    return {masterRole(m_bus.latest()), masterText(m_bus.latest())};
}

std::vector<BusNode> RingOutline::nodes() const
{
    return nodesOf(m_bus.structure(), m_bus.catalog(), [this](const Participant &participant) {
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
    if (node < m_bus.latest().devices.size())
        state.position = m_bus.latest().devices[node].reading.position;
    return state;
}

StateWord RingOutline::shown(std::size_t node) const
{
    if (node >= m_bus.latest().devices.size())
        return {Role::inactive, tr("not seen yet")};
    const NodeId number = m_bus.structure()[node].number;
    const Snapshot::Device &device = m_bus.latest().devices[node];
    const WordChannel *channel = m_bus.channel(number);
    if (auto fault = faultOf(node))
        return *fault;
    if (!device.inRing)
        return {Role::inactive, tr("not in the ring")};
    if (!m_bus.isRunning())
        return {Role::inactive, tr("stopped")};
    const bool exchanged = m_bus.latest().cycle > 0;
    if (exchanged && m_bus.encoder(number) == nullptr) // no driver that could tell more
        return {Role::running, tr("ok")};
    if (device.reading.state == EncoderState::error)
        return {Role::fault, errorText(m_bus.encoder(number), device.reading)};
    if (device.heldByJob)
        return {Role::attention, tr("job running")};
    if (channel != nullptr && channel->staged())
        return {Role::attention, tr("OUT not sent")};
    switch (device.reading.state) {
    case EncoderState::parameterization:
        return {Role::attention, tr("parameterization")};
    case EncoderState::readOut:
        return {Role::attention, tr("read-out")};
    case EncoderState::service:
        return {Role::attention, tr("service mode")};
    case EncoderState::silent:
        return {Role::fault, tr("silent")};
    case EncoderState::unknown:
        return {Role::attention, tr("unknown state")};
    case EncoderState::notSeen:
        return {Role::inactive, tr("not seen yet")};
    case EncoderState::operation:
    case EncoderState::error:
        break;
    }
    return {Role::running, tr("ok")};
}

// What the master says of this very device.
std::optional<StateWord> RingOutline::faultOf(std::size_t node) const
{
    const MasterStatus *master = m_bus.master();
    if (master == nullptr)
        return std::nullopt;
    const NodeId number = m_bus.structure()[node].number;
    const auto at = master->faultPlace();
    if (at && at->number == number)
        return StateWord{Role::fault, master->faultText()};
    if (node < master->devices.size() && master->devices[node].peripheralFault)
        return StateWord{Role::fault,
                         busFaultText(bus_error::peripheralFault, diagnosticParameterOf({.number = number}))};
    return std::nullopt;
}

// How the position stands in IN, where it is not plain binary.
QString RingOutline::codingText(const Participant &participant) const
{
    const EncoderSession *encoder = m_bus.encoder(participant.number);
    const auto coding = encoder == nullptr ? std::nullopt : encoder->latest().coding;
    if (coding == PositionCoding::gray)
        return tr("Position: Gray code");
    if (coding == PositionCoding::signedBinary)
        return tr("Position: signed");
    return {};
}

// On the housing, as they have to be.
QString RingOutline::ledsText(std::size_t node) const
{
    const Snapshot &ring = m_bus.latest();
    if (node >= ring.devices.size() || !hasRemoteBusLeds(m_bus.encoder(m_bus.structure()[node].number)))
        return {};
    return tr("LEDs: %1").arg(ledText(ledsOf(ring.state, ring.devices[node].inRing)));
}

QString RingOutline::toolTip(std::size_t node, const QString &called) const
{
    if (node >= m_bus.structure().size())
        return {};
    const Participant &participant = m_bus.structure()[node];
    QStringList lines{toolTipOf(participant, called, shown(node).word), ledsText(node),
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
    return nodesOf(m_structure, m_catalog, [this](const Participant &participant) {
        return m_catalog.find(participant.deviceKey, participant.deviceCode);
    });
}

QString PlannedRingOutline::toolTip(std::size_t node, const QString &called) const
{
    return toolTipOf(m_structure[node], called, planned().word);
}

} // namespace codewheel
