// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/buses.h"

#include "kinds/canopen/finder/slcan_spoken_protocol.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/esc/finder/esc_spoken_protocol.h"
#include "kinds/esc/line/esc_line_rows.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/interbus/finder/gateway_rtu_protocol.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/ring_rows.h"

namespace codewheel {

std::vector<std::unique_ptr<const BusKind>> builtInBusKinds()
{
    std::vector<std::unique_ptr<const BusKind>> kinds;
    kinds.push_back(makeRingKind());
    kinds.push_back(makeLineKind());
    kinds.push_back(makeCanopenKind());
    return kinds;
}

std::vector<std::unique_ptr<const SpokenProtocol>> builtInSpokenProtocols()
{
    std::vector<std::unique_ptr<const SpokenProtocol>> protocols;
    protocols.push_back(makeEscProtocol());
    protocols.push_back(makeRtuProtocol());
    protocols.push_back(makeSlcanProtocol());
    return protocols;
}

std::unique_ptr<RecordedRows> rowsWithoutProfile(bool hasWords)
{
    return hasWords ? makeRingRows() : makeEscLineRows();
}

} // namespace codewheel
