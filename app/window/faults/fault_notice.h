// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_faults.h"

#include <QObject>

#include <functional>

class QVBoxLayout;

namespace codewheel {

class BusViews;
class FaultBanner;
class Plant;

// What is wrong on any bus, above the pages of the window: checks all buses with each frame, and passes the
// actions of the banner to the views that can carry them out.
class FaultNotice : public QObject
{
    Q_OBJECT

public:
    using ViewsOf = std::function<BusViews *(BusId bus)>; // null: it has none

    // The plant outlives it. The banner goes above the other notices.
    FaultNotice(Plant &plant, ViewsOf viewsOf, QVBoxLayout &notices, QObject *parent);

    void showFrame();
    // The worst fault of each bus that is `meant`: "Ring 2: BUS FAIL".
    QStringList inBrief(const std::function<bool(BusId bus)> &isMeant) const;

Q_SIGNALS:
    void changed(); // there are others, or they are told otherwise
    void shown(codewheel::BusId bus, const codewheel::Fault &fault); // its place is to be chosen

private:
    QString nameOf(BusId bus) const;
    void act(BusId bus, const Fault &fault, FaultAction action);

    Plant &m_plant;
    const ViewsOf m_viewsOf;
    BusFaults m_faults;
    FaultBanner *m_banner;
};

} // namespace codewheel
