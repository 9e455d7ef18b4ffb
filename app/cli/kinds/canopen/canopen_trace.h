// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/encoder/job_trace.h"
#include "kinds/canopen/bus/canopen_event.h"

#include <QObject>

namespace codewheel {

class CanopenSession;

// The frames that pass while it lives, without what is asked again and again; each place has those of its
// node.
class CanopenTrace final : public JobTrace
{
public:
    explicit CanopenTrace(const CanopenSession &bus);

    QString text(Place place) const override;
    QJsonArray json(Place place) const override;

private:
    struct Row
    {
        CanopenRow row;
        int node = 0; // 0: of all
    };
    std::vector<CanopenRow> rowsOf(Place place) const;

    QObject m_scope;
    std::vector<Row> m_rows;
};

// "185", of 29 bits "0CFFE0E0"
QString identifierText(const CanFrame &frame);
// "88 13 00 00"
QString octetsText(std::span<const std::uint8_t> octets);

} // namespace codewheel
