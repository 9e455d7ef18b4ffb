// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/object_transfers.h"

#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/encoder_objects.h"

namespace codewheel {
namespace {

// Storing, restoring and the preset take their time.
bool takesLong(canopen::SdoObject object)
{
    return object.index == canopen::object::store.index || object.index == canopen::object::restore.index ||
           object.index == canopen::object::preset.index;
}

} // namespace

ObjectTransfers::ObjectTransfers(QObject *parent)
    : QObject(parent)
{}

void ObjectTransfers::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = bus;
    m_waiting.clear();
    m_underWay.reset();
    if (bus != nullptr)
        connect(bus, &CanopenSession::transferEnded, this, &ObjectTransfers::takeEnd);
    Q_EMIT changed();
}

void ObjectTransfers::setNode(std::optional<int> node)
{
    if (std::exchange(m_node, node) == node)
        return;
    m_underWay.reset();
    cancel();
}

void ObjectTransfers::read(const std::vector<canopen::SdoObject> &objects)
{
    if (!m_node)
        return;
    for (const canopen::SdoObject &object : objects)
        m_waiting.push_back({.node = *m_node, .object = object});
    sendNext();
}

void ObjectTransfers::write(canopen::SdoObject object, const std::vector<std::uint8_t> &octets)
{
    if (!m_node)
        return;
    constexpr Instant longestStoring = std::chrono::seconds(5);
    canopen::SdoRequest request{.node = *m_node, .object = object, .value = octets};
    if (takesLong(object))
        request.timeOut = longestStoring;
    m_waiting.push_back(request);
    sendNext();
}

void ObjectTransfers::cancel()
{
    m_waiting.clear();
    Q_EMIT changed();
}

void ObjectTransfers::sendNext()
{
    if (!m_underWay && !m_waiting.empty() && m_bus) {
        m_underWay = m_waiting.front();
        m_waiting.pop_front();
        m_bus->transfer(*m_underWay);
    }
    Q_EMIT changed();
}

void ObjectTransfers::takeEnd(const TransferEnded &end)
{
    if (!m_underWay || end.request != *m_underWay)
        return;
    using Kind = canopen::SdoOutcome::Kind;
    m_underWay.reset();
    if (end.refused || end.outcome.kind == Kind::notSent || end.outcome.kind == Kind::noAnswer)
        m_waiting.clear(); // the others would not be answered, either
    if (end.refused)
        Q_EMIT refused(*end.refused);
    else
        Q_EMIT ended(end.request, end.outcome);
    sendNext();
}

} // namespace codewheel
