// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_connection.h"

#include "app/window/buses/leaving.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/comparison.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/send_permission.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"

#include <utility>

namespace codewheel {

RingConnection::RingConnection(RingAtWork &ring, ProjectDocument &project, Leaving &leaving,
                               InlineMessage &notice, QObject *parent)
    : QObject(parent)
    , m_ring(ring)
    , m_bus(*ring.bus())
    , m_project(project)
    , m_leaving(leaving)
    , m_notice(notice)
{
    connect(&m_bus, &RingSession::openRefused, this, &RingConnection::refused);
    connect(&m_bus, &RingSession::stateChanged, this, [this] {
        Q_EMIT changed();
        if (m_bus.isOperating() && std::exchange(m_isRefused, false))
            m_notice.withdraw();
    });
    connect(&m_bus, &RingSession::readInProgressed, this, [this](int devices) {
        m_notice.showMessage(Role::attention, tr("Reading in the ring: %n devices found.", nullptr, devices));
    });
    connect(&m_bus, &RingSession::readInEnded, this, [this] {
        m_notice.withdraw();
        Q_EMIT changed();
        tellComparison();
    });
    connect(&m_bus, &RingSession::readInFailed, this, [this](const Refusal &why) {
        m_notice.showMessage(Role::fault, refusalText(why));
        Q_EMIT changed();
    });
    connect(&m_bus, &RingSession::nodesChanged, this, [this] {
        if (m_bus.isOpen() && std::exchange(m_isConnecting, false))
            ringConnected();
    });
    connect(&m_bus, &RingSession::structureChanged, this, &RingConnection::ringChanged);
}

void RingConnection::connectRing()
{
    if (m_bus.state() != BusState::closed)
        return;
    m_isConnecting = true;
    // What the bus refuses, it reports by itself.
    if (const auto opened = m_ring.open(); !opened && opened.error().kind == RefusalKind::badInput)
        Q_EMIT refused(opened.error());
}

void RingConnection::ringConnected()
{
    m_notice.withdraw();
    Q_EMIT changed();
    if (m_ring.gateway())
        Q_EMIT told({.severity = Severity::information,
                     .id = MessageId::connected,
                     .arguments = {gatewayText(*m_ring.gateway())}});
    tellComparison();
}

void RingConnection::disconnectRing()
{
    if (!m_bus.isOpen()) { // it is still opening
        m_bus.close();
        return;
    }
    m_leaving.ask(Leaving::Why::disconnect, {&m_bus}, [this] {
        m_bus.close();
        m_notice.withdraw();
        Q_EMIT changed();
        Q_EMIT told({.severity = Severity::information, .id = MessageId::disconnected});
    });
}

void RingConnection::startAfresh()
{
    m_isConnecting = true;
    m_ring.startAfresh();
}

bool RingConnection::mayChangeRing()
{
    const auto allowed = codewheel::mayChangeRing(m_bus.latest());
    m_isRefused = !allowed;
    if (m_isRefused)
        m_notice.showMessage(Role::attention, refusalText(allowed.error()));
    return !m_isRefused;
}

void RingConnection::confirmDiagnostics()
{
    if (mayChangeRing())
        m_bus.confirmDiagnostics();
}

void RingConnection::readIn()
{
    if (!mayChangeRing())
        return;
    m_leaving.ask(Leaving::Why::stop, {&m_bus}, [this] {
        m_bus.readIn();
        Q_EMIT changed();
    });
}

// What a gateway shows is what the project says.
void RingConnection::tellComparison()
{
    if (m_ring.gateway())
        return;
    const int devices = static_cast<int>(m_bus.structure().size());
    const int others =
        differences(compareRings(structureOf(m_project.project(), m_ring.id()), m_bus.structure()));
    if (others == 0)
        Q_EMIT told({.severity = Severity::information,
                     .id = RingMessageId::ringAsConfigured,
                     .arguments = {std::int64_t{devices}}});
    else
        Q_EMIT told({.severity = Severity::attention,
                     .id = RingMessageId::ringDiffers,
                     .arguments = {std::int64_t{others}}});
}

} // namespace codewheel
