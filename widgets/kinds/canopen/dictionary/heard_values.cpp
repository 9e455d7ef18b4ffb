// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/heard_values.h"

#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/eds/device_file.h"

namespace codewheel {

HeardValues::HeardValues(QObject *parent)
    : QObject(parent)
{}

void HeardValues::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    if (bus != m_bus && bus != nullptr) {
        m_heard = {};
        m_news.clear();
        m_identities.clear();
    }
    m_bus = bus;
    setNode(m_node);
    if (bus != nullptr)
        connect(bus, &CanopenSession::passed, this, &HeardValues::hear);
}

// What the PDOs of the one before have shown is not news any more when it is chosen again.
void HeardValues::setNode(std::optional<int> node)
{
    m_node = node;
    m_heard.setNodeOfPdos(node);
}

canopen::ToldIdentity HeardValues::identityOf(int node) const
{
    const auto found = m_identities.find(node);
    return found != m_identities.end() ? found->second : canopen::ToldIdentity();
}

std::vector<canopen::HeardObject> HeardValues::takeNews()
{
    std::vector<canopen::HeardObject> all;
    const auto found = m_node ? m_news.find(*m_node) : m_news.end();
    if (found == m_news.end())
        return all;
    for (auto &[object, heard] : found->second)
        all.push_back(std::move(heard));
    m_news.erase(found);
    return all;
}

void HeardValues::hear(const CanopenRow &row, Instant at)
{
    for (const canopen::HeardObject &heard : m_heard.take(row.frame, row.isSent, at))
        take(heard);
}

void HeardValues::take(const canopen::HeardObject &heard)
{
    const auto order = canopen::orderOf(heard.object);
    if (heard.isOurs)
        m_news[heard.node].erase(order);
    else if (!heard.value.empty())
        m_news[heard.node].insert_or_assign(order, heard);
    takeIdentity(heard);
    if (!heard.isOurs && heard.how == canopen::HeardObject::How::written)
        Q_EMIT written(heard);
}

void HeardValues::takeIdentity(const canopen::HeardObject &heard)
{
    constexpr std::uint16_t identityIndex = 0x1018;
    const std::size_t sub = heard.object.sub;
    if (heard.object.index != identityIndex || sub == 0 || sub > canopen::NodeIdentity::size ||
        heard.value.empty())
        return;
    m_identities[heard.node].at(sub - 1) = canopen::numberOf(heard.value);
    Q_EMIT identityTold(heard.node);
}

} // namespace codewheel
