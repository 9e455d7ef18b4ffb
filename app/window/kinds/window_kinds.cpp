// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/window_kinds.h"

#include "app/window/connect/port_rows.h"
#include "app/window/kinds/canopen/can_interface_rows.h"
#include "app/window/kinds/canopen/canopen_at_work.h"
#include "app/window/kinds/canopen/canopen_views.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/kinds/esc/esc_line_views.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/kinds/interbus/ring_views.h"
#include "app/window/recording/replay_at_work.h"
#include "app/window/recording/replay_views.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/interbus/finder/gateway_host_finder.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/plan/ring_plan.h"

#include <algorithm>

namespace codewheel {
namespace {

template <class AtWork>
std::unique_ptr<BusAtWork> make(BusId id, const BusAtWork::Surroundings &surroundings)
{
    return std::make_unique<AtWork>(id, surroundings);
}

template <class Views, class AtWork>
BusViews *makeViews(BusAtWork &bus, const WindowParts &parts, QObject *parent)
{
    return new Views(static_cast<AtWork &>(bus), parts, parent);
}

HostSearch gatewaySearch(const QString &host, int port)
{
    GatewaySettings where;
    where.host = host;
    where.tcpPort = port;
    return {gatewayAddress(where), GatewayHostFinder::announcement(),
            std::make_unique<GatewayHostFinder>(where, [](const GatewaySettings &settings) {
                return std::make_unique<ModbusPort>(settings);
            })};
}

// The list of kinds.
std::vector<WindowKind> &kinds()
{
    static std::vector<WindowKind> all{
        {QString::fromLatin1(interbusKind), &make<RingAtWork>, &makeViews<RingViews, RingAtWork>, ringPanels,
         nullptr, &gatewaySearch},
        {QString::fromLatin1(escKind), &make<EscLineAtWork>, &makeViews<EscLineViews, EscLineAtWork>,
         linePanels, &adapterRows, nullptr, &keysOfLines},
        {QString::fromLatin1(canopenKind), &make<CanopenAtWork>, &makeViews<CanopenViews, CanopenAtWork>,
         canPanels, &canAdapterRows, nullptr, nullptr, &canInterfacesToHear, &canInterfaceFinder},
        {ReplayAtWork::kindKey(), nullptr, &makeViews<ReplayViews, ReplayAtWork>}};
    return all;
}

} // namespace

std::vector<const WindowKind *> windowKinds()
{
    std::vector<const WindowKind *> all;
    for (const WindowKind &kind : kinds())
        all.push_back(&kind);
    return all;
}

const WindowKind *windowKind(QStringView bus)
{
    const auto found = std::ranges::find(kinds(), bus, &WindowKind::bus);
    return found == kinds().end() ? nullptr : &*found;
}

void addWindowKind(WindowKind kind)
{
    kinds().push_back(std::move(kind));
}

} // namespace codewheel
