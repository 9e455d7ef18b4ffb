// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/traffic/can_traffic_rows.h"

#include "kinds/canopen/bus/canopen_traffic.h"

namespace codewheel {

std::vector<TrafficRow> CanTrafficRows::next(const TrafficRow &row)
{
    std::vector<TrafficRow> rows;
    TrafficRow own = row;
    if (const auto frame = canFrameOf(row.bytes)) {
        const auto taken = m_dialogues.take(*frame, row.at);
        for (const canopen::SdoDialogue &ended : taken.ended)
            rows.push_back(whole(ended));
        own.isOfTransfer = taken.isPart;
        const auto cob = canopen::CobId::of(frame->id);
        if (taken.isPart && cob && cob->service == canopen::CobId::Service::sdoRequest)
            m_begun.try_emplace(cob->node, row);
    }
    rows.push_back(std::move(own));
    return rows;
}

std::vector<TrafficRow> CanTrafficRows::overdue(Instant now)
{
    std::vector<TrafficRow> rows;
    for (const canopen::SdoDialogue &ended : m_dialogues.overdue(now))
        rows.push_back(whole(ended));
    return rows;
}

// It has the time, the place and the maker of its request, and the octets of its value.
TrafficRow CanTrafficRows::whole(const canopen::SdoDialogue &ended)
{
    TrafficRow row;
    if (const auto begun = m_begun.extract(ended.node))
        row = begun.mapped();
    row.kind.reset();
    row.head = 0;
    row.bytes = QByteArray(reinterpret_cast<const char *>(ended.value.data()),
                           static_cast<qsizetype>(ended.value.size()));
    row.meaning = [ended] { return ended.text(); };
    return row;
}

} // namespace codewheel
