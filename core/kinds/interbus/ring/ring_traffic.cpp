// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_traffic.h"

#include "catalog/explain_exchange.h"

namespace codewheel {

TrafficRow RingTraffic::row(Place place, const Exchange &exchange)
{
    const auto asked = askedWord(*m_device, exchange, m_last ? &*m_last : nullptr);
    m_last = exchange;
    return {
        .at = exchange.at,
        .place = place,
        .cycle = exchange.cycle,
        .out = exchange.out,
        .in = exchange.in,
        .isAnswered = exchange.isAnswered,
        .meaning = [device = m_device, exchange, asked] { return exchangeText(*device, exchange, asked); }};
}

} // namespace codewheel
