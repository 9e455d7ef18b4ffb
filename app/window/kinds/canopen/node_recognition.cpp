// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/node_recognition.h"

#include "catalog/catalog.h"
#include "widgets/project/project_document.h"

#include <utility>

namespace codewheel {
namespace {

constexpr std::uint16_t identityIndex = 0x1018;
constexpr std::uint8_t vendorSub = 1;
constexpr std::uint8_t revisionSub = 3;

} // namespace

NodeRecognition::NodeRecognition(const ProjectDocument &project, QObject *parent)
    : QObject(parent)
    , m_project(project)
{}

void NodeRecognition::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    forget();
    if (bus == nullptr)
        return;
    m_canRecognise = canopen::describesNodes(bus->catalog().devices());
    connect(bus, &CanopenSession::passed, this, &NodeRecognition::hear);
    connect(bus, &CanopenSession::meetsAgain, this, &NodeRecognition::forget);
}

void NodeRecognition::forget()
{
    m_nodes.clear();
    m_heard = {};
}

void NodeRecognition::hear(const CanopenRow &row, Instant at)
{
    if (!m_canRecognise)
        return;
    for (const canopen::HeardObject &heard : m_heard.take(row.frame, row.isSent, at)) {
        const std::uint8_t sub = heard.object.sub;
        if (heard.object.index != identityIndex || sub < vendorSub || sub > revisionSub)
            continue;
        Node &node = m_nodes[heard.node];
        if (!heard.value.empty())
            node.identity.at(sub - vendorSub) = canopen::numberOf(heard.value);
        node.isComplete = node.isComplete || sub == revisionSub;
    }
}

// A job that runs keeps it from being described: then later.
void NodeRecognition::goOn()
{
    if (!m_canRecognise || !m_bus || !m_bus->isOpen())
        return;
    for (const Place place : m_bus->places()) {
        const int number = CanopenAddress::of(place.node).node;
        if (unnamed(number) == nullptr)
            continue;
        if (const auto node = m_nodes.find(number); node != m_nodes.end() && node->second.isComplete)
            describe(number, node->second.identity);
        else if (mayAsk(number))
            ask(number);
    }
}

const EncoderSession *NodeRecognition::unnamed(int node) const
{
    const EncoderSession *encoder = m_bus->encoder(m_bus->placeOf(CanopenAddress{node}.place()));
    return encoder != nullptr && encoder->device().isGeneric() && !encoder->runningJob() ? encoder : nullptr;
}

bool NodeRecognition::mayAsk(int node) const
{
    const CanopenSnapshot &now = m_bus->latest();
    const auto known = m_nodes.find(node);
    const bool isAsked = known != m_nodes.end() && known->second.isAsked;
    return !isAsked && m_bus->isOperating() && now.connected && !now.isHeldBack() &&
           now.heard(node) != nullptr;
}

void NodeRecognition::ask(int node)
{
    m_nodes[node].isAsked = true;
    for (std::uint8_t sub = vendorSub; sub <= revisionSub; ++sub)
        m_bus->transfer({.node = node, .object = {identityIndex, sub}});
}

void NodeRecognition::describe(int node, const canopen::ToldIdentity &identity)
{
    if (std::exchange(m_nodes[node].isDone, true))
        return;
    const DeviceDescription *device = canopen::describedNode(m_bus->catalog().devices(), identity);
    if (device == nullptr)
        return;
    const QString name = device->fullName();
    const Place place = m_bus->placeOf(CanopenAddress{node}.place());
    const ProjectDevice *planned = findDevice(m_project.project(), place);
    const DeviceLabel label = planned != nullptr ? planned->label : DeviceLabel();
    if (m_bus->name(place, device->key, label.turns, label.stepsPerTurn))
        Q_EMIT recognised(place, name);
}

} // namespace codewheel
