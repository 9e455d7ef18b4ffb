// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/latest_snapshot.h"

#include <utility>

namespace codewheel {
namespace {

void replaceKeepingEdges(Snapshot &older, const Snapshot &newer)
{
    std::vector<Snapshot::Device> devices = std::move(older.devices);
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const Word outEdges = devices[i].outEdges;
        const Word inEdges = devices[i].inEdges;
        devices[i] = newer.devices[i];
        devices[i].outEdges |= outEdges;
        devices[i].inEdges |= inEdges;
    }
    older.cycle = newer.cycle;
    older.at = newer.at;
    older.state = newer.state;
    older.operate = newer.operate;
    older.lateCycles = newer.lateCycles;
    older.period = newer.period;
    older.droppedRows = newer.droppedRows;
    older.devices = std::move(devices);
    older.master = newer.master;
}

} // namespace

void LatestSnapshot::publish(const Snapshot &newest)
{
    const std::scoped_lock lock(m_mutex);
    if (m_untaken)
        replaceKeepingEdges(*m_untaken, newest);
    else
        m_untaken = std::make_shared<Snapshot>(newest);
}

std::shared_ptr<const Snapshot> LatestSnapshot::take()
{
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_untaken, nullptr);
}

} // namespace codewheel
