// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_rows.h"

#include "kinds/interbus/ring/ring_traffic.h"

#include <map>

namespace codewheel {
namespace {

class WordRows final : public RecordedRows
{
public:
    std::span<const TrafficColumn> columns() const override { return ringTrafficColumns; }
    TrafficRow explained(TrafficRow row, const EncoderAt &encoder) override
    {
        const EncoderSession *its = row.place ? encoder(*row.place) : nullptr;
        if (its == nullptr)
            return row;
        RingTraffic &traffic = m_traffic.try_emplace(*row.place, its->device()).first->second;
        const Reading &reading = its->latest();
        const Exchange exchange{row.cycle, row.at, row.out, row.in, reading.mode, reading.coding};
        row.meaning = traffic.row(*row.place, exchange).meaning;
        return row;
    }
    void restart() override { m_traffic.clear(); }

private:
    std::map<Place, RingTraffic> m_traffic;
};

} // namespace

std::unique_ptr<RecordedRows> makeRingRows()
{
    return std::make_unique<WordRows>();
}

} // namespace codewheel
