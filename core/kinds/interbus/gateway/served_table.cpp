// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/served_table.h"

#include "kinds/interbus/gateway/served_ring.h"

namespace codewheel {

std::vector<ServedRegisters> servedTable(const RingStructure &ring)
{
    const auto map = servedMap(ring);
    std::vector<ServedRegisters> table;
    for (std::size_t i = 0; map && i < ring.size(); ++i) {
        const RegisterBlock &in = map->in(i);
        table.push_back({.place = ring[i].number,
                         .in = in,
                         .inHolding = {in.first + served_registers::inAsHolding, in.count},
                         .out = map->out(i)});
    }
    return table;
}

} // namespace codewheel
