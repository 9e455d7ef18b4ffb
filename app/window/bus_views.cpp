// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/bus_views.h"

#include "app/window/line_at_work.h"
#include "app/window/line_views.h"
#include "app/window/ring_at_work.h"
#include "app/window/ring_views.h"

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

BusViews *makeBusViews(BusAtWork &bus, const WindowParts &parts, QObject *parent)
{
    if (auto *ring = qobject_cast<RingAtWork *>(&bus))
        return new RingViews(*ring, parts, parent);
    if (auto *line = qobject_cast<LineAtWork *>(&bus))
        return new LineViews(*line, parts, parent);
    return nullptr;
}

} // namespace codewheel
