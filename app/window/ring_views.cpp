// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ring_views.h"

#include "app/window/ring_at_work.h"
#include "app/window/ring_connection.h"
#include "app/window/status_line.h"
#include "app/window/window_actions.h"
#include "encoder/device_number.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/device/device_panel.h"
#include "widgets/master/master_panel.h"
#include "widgets/project/device_names.h"
#include "widgets/structure_editor/structure_editor.h"
#include "widgets/training/training_panel.h"

#include <QAction>
#include <QStackedWidget>

namespace codewheel {

RingViews::RingViews(RingAtWork &ring, const WindowParts &parts, QObject *parent)
    : BusViews(parent)
    , m_ring(ring)
    , m_parts(parts)
    , m_connection(new RingConnection(ring, ring.project(), parts.leaving, parts.actions, parts.notice, this))
    , m_master(new MasterPanel(*ring.bus(), &parts.pages))
    , m_training(new TrainingPanel(ring.controls(), ring.id(), &parts.pages))
    , m_comparison(new ComparisonPage(ring.project(), *ring.bus(), &parts.pages))
{
    new DeviceNames(ring.project(), *ring.bus(), this);
    parts.pages.addWidget(m_comparison);
    connect(m_connection, &RingConnection::told, this, &RingViews::told);
    connect(m_connection, &RingConnection::ringChanged, this, &RingViews::devicesChanged);
    connect(m_master, &MasterPanel::startRequested, this, &RingViews::startRequested);
    connect(m_master, &MasterPanel::stopRequested, this, &RingViews::stopRequested);
    connect(m_master, &MasterPanel::readInRequested, m_connection, &RingConnection::readIn);
    connect(m_master, &MasterPanel::asked, this, &RingViews::open);
    connect(m_comparison, &ComparisonPage::readInRequested, m_connection, &RingConnection::readIn);
    connect(m_training, &TrainingPanel::acted, this,
            [this](Place place, const QString &what) { tellTraining(place, MessageId::training, what); });
    connect(m_training, &TrainingPanel::planned, this,
            [this](Place place, const QString &what) { tellTraining(place, MessageId::faultPlan, what); });
    connect(parts.actions.compare, &QAction::triggered, this, &RingViews::showComparison);
    connect(parts.actions.switchSegment, &QAction::triggered, this, [this] {
        if (m_isCurrent && m_chosen)
            m_master->toggleSegment(DeviceNumber::of(m_chosen->node).segment);
    });
    connect(ring.bus(), &BusSession::stateChanged, this, &RingViews::showState);
    m_comparison->setConnected(ring.isOpen());
}

RingViews::~RingViews()
{
    for (QWidget *widget : {static_cast<QWidget *>(m_master), static_cast<QWidget *>(m_training),
                            static_cast<QWidget *>(m_comparison)})
        delete widget;
}

std::vector<BusViews::Panel> RingViews::panels() const
{
    return {{"trainingDock", m_training}, {"masterDock", m_master}};
}

void RingViews::setCurrent(bool isCurrent)
{
    m_isCurrent = isCurrent;
    m_connection->setCurrent(isCurrent);
    m_parts.device.setRing(isCurrent ? m_ring.bus() : nullptr);
    if (isCurrent)
        m_parts.editor.setRing(m_ring.id());
    showActions();
}

void RingViews::setChosen(std::optional<Place> place)
{
    m_chosen = place;
    if (place) {
        m_training->setDevice(*place);
        m_parts.editor.choose(*place);
    }
}

void RingViews::open()
{
    Q_EMIT panelRequested("masterDock");
}

void RingViews::showPicture()
{
    m_training->refresh();
}

void RingViews::showState()
{
    m_comparison->setConnected(m_ring.isOpen());
    if (m_isCurrent)
        showActions();
}

void RingViews::showActions()
{
    const bool hasMaster = m_isCurrent && m_ring.isOpen() && m_ring.bus()->master() != nullptr;
    m_parts.actions.confirmDiagnostics->setEnabled(hasMaster);
    m_parts.actions.switchSegment->setEnabled(hasMaster);
    m_parts.status.setBus(m_isCurrent && m_ring.isOpen() ? m_ring.bus() : nullptr, tr("training bus"));
}

void RingViews::showComparison()
{
    if (!m_isCurrent)
        return;
    m_parts.pages.setCurrentWidget(m_comparison);
    m_comparison->setFocus();
}

void RingViews::tellTraining(Place place, MessageId what, const QString &text)
{
    Q_EMIT told({.place = place.isEmpty() ? std::nullopt : std::optional(place),
                 .severity = Severity::information,
                 .id = what,
                 .arguments = {text}});
}

} // namespace codewheel
