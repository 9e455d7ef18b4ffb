// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/bus_views.h"

#include "app/window/look/afresh.h"
#include "app/window/look/described_action.h"
#include "widgets/training/training_area.h"

#include <QWidget>

#include <algorithm>

namespace codewheel {

BusViews::~BusViews()
{
    for (QWidget *widget : m_own) // all first: one that goes may bring another to the front
        widget->disconnect(this);
    qDeleteAll(m_own);
}

bool BusViews::owns(const QWidget *page) const
{
    return std::ranges::find(m_own, page) != m_own.end();
}

void BusViews::setCurrent(bool isCurrent)
{
    m_isCurrent = isCurrent;
    showCurrent();
}

void BusViews::setCalled(const QString &called, bool isDoubtful)
{
    if (m_called == called && m_isDoubtful == isDoubtful)
        return;
    m_called = called;
    m_isDoubtful = isDoubtful;
    if (m_isCurrent) // the others have nothing to show
        showCurrent();
}

void BusViews::showAfresh(TrainingArea *panel, QAction *action, const QString &whyNot)
{
    const QString tip = Afresh::tip(whyNot);
    if (panel != nullptr)
        panel->offerAfresh(whyNot.isEmpty(), tip);
    if (!m_isCurrent)
        return;
    described(action, action->shortcut(), tip);
    action->setEnabled(isMeant() && whyNot.isEmpty());
}

void BusViews::tellTraining(Place place, const TrainingAct &what, MessageCode id)
{
    Q_EMIT told({.place = place, .severity = Severity::information, .id = id, .arguments = what});
}

} // namespace codewheel
