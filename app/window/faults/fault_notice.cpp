// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/faults/fault_notice.h"

#include "app/window/buses/bus_views.h"
#include "app/window/buses/plant.h"
#include "bus/buses.h"

#include <QVBoxLayout>

#include <set>

namespace codewheel {

FaultNotice::FaultNotice(Plant &plant, ViewsOf viewsOf, QVBoxLayout &notices, QObject *parent)
    : QObject(parent)
    , m_plant(plant)
    , m_viewsOf(std::move(viewsOf))
    , m_banner(new FaultBanner([this](BusId bus, const Fault &fault, FaultAction action) {
        const BusViews *views = m_viewsOf(bus);
        return views != nullptr ? views->offer(fault, action) : FaultBanner::Offer();
    }))
{
    notices.insertWidget(0, m_banner);
    connect(m_banner, &FaultBanner::showRequested, this, &FaultNotice::shown);
    connect(m_banner, &FaultBanner::actionRequested, this, &FaultNotice::act);
}

void FaultNotice::showFrame()
{
    const auto before = m_faults.all();
    const bool isOther = m_faults.look(m_plant.buses()) != before;
    m_banner->showFaults(m_faults, [this](BusId bus) { return nameOf(bus); });
    if (isOther)
        Q_EMIT changed();
}

// The name is given where it could be any of several buses.
QString FaultNotice::nameOf(BusId bus) const
{
    return m_faults.areOnSeveralBuses() ? m_plant.nameOf(bus) : nameAmongOthers(bus);
}

void FaultNotice::act(BusId bus, const Fault &fault, FaultAction action)
{
    if (BusViews *views = m_viewsOf(bus))
        views->act(fault, action);
}

QStringList FaultNotice::inBrief(const std::function<bool(BusId)> &isMeant) const
{
    QStringList texts;
    std::set<BusId> told;
    for (const auto &[bus, fault] : m_faults.all()) {
        if (fault.shown.role != Role::fault || !isMeant(bus) || !told.insert(bus).second)
            continue;
        const bool isOfDevice = fault.extent == Fault::Extent::device;
        const QString what = isOfDevice ? QStringLiteral("%1 %2").arg(fault.node.toString(), fault.shown.word)
                                        : fault.shown.word;
        texts << QStringLiteral("%1: %2").arg(m_plant.nameOf(bus), what);
    }
    return texts;
}

} // namespace codewheel
