// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_event.h"
#include "kinds/canopen/protocol/described_node.h"
#include "kinds/canopen/protocol/objects_heard.h"

#include <QObject>
#include <QPointer>

#include <map>

namespace codewheel {

class CanopenSession;

// What is heard on the bus of the objects of its nodes while others ask for them and write them, and what is
// in the PDOs of the chosen node. For the view of objects.
class HeardValues final : public QObject
{
    Q_OBJECT

public:
    explicit HeardValues(QObject *parent = nullptr);

    void setBus(codewheel::CanopenSession *bus); // null: none; nothing of another one is kept
    void setNode(std::optional<int> node);
    // The newest of each object of the chosen node since the last time, unless we have read it since.
    std::vector<canopen::HeardObject> takeNews();
    // As it was told, to us or to others.
    canopen::ToldIdentity identityOf(int node) const;

Q_SIGNALS:
    // By another master, who has its acknowledgement.
    void written(const codewheel::canopen::HeardObject &object);
    void identityTold(int node);

private:
    using News = std::map<std::pair<std::uint16_t, std::uint8_t>, canopen::HeardObject>;

    void hear(const CanopenRow &row, Instant at);
    void take(const canopen::HeardObject &heard);
    void takeIdentity(const canopen::HeardObject &heard);

    QPointer<CanopenSession> m_bus;
    std::optional<int> m_node;
    canopen::ObjectsHeard m_heard;
    std::map<int, News> m_news; // by node
    std::map<int, canopen::ToldIdentity> m_identities;
};

} // namespace codewheel
