// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/bus_views.h"

#include <QWidget>

namespace codewheel {

BusViews::~BusViews()
{
    for (QWidget *widget : m_own) {
        widget->disconnect(this);
        delete widget;
    }
}

void BusViews::setCurrent(bool isCurrent)
{
    m_isCurrent = isCurrent;
    showCurrent();
}

void BusViews::tellTraining(Place place, const QString &what, MessageId id)
{
    Q_EMIT told({.place = place, .severity = Severity::information, .id = id, .arguments = {what}});
}

} // namespace codewheel
