// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_rows.h"

#include "kinds/esc/line/row_text.h"

namespace codewheel {
namespace {

class ByteRows final : public RecordedRows
{
public:
    std::span<const TrafficColumn> columns() const override { return lineTrafficColumns; }
    bool areOfTerminal() const override { return true; }
    TrafficRow explained(TrafficRow row, const EncoderAt &) override
    {
        if (row.kind)
            row.meaning = m_traffic.row({.at = row.at, .kind = *row.kind, .bytes = row.bytes}).meaning;
        return row;
    }
    void restart() override { m_traffic = EscLineTraffic(); }

private:
    EscLineTraffic m_traffic;
};

} // namespace

std::unique_ptr<RecordedRows> makeEscLineRows()
{
    return std::make_unique<ByteRows>();
}

} // namespace codewheel
