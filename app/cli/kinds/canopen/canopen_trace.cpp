// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/canopen_trace.h"

#include "can/frame_meaning.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/recording/frame_rows.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/cob_id.h"

namespace codewheel {

CanopenTrace::CanopenTrace(const CanopenSession &bus)
{
    QObject::connect(&bus, &CanopenSession::passed, &m_scope, [this](const CanopenRow &row) {
        const bool isStandard = !row.frame.isExtended && !row.frame.isError;
        const auto cob = isStandard ? canopen::CobId::of(row.frame.id) : std::nullopt;
        if (!row.isAutomatic)
            m_rows.push_back({row, cob ? cob->node : 0});
    });
}

std::vector<CanopenRow> CanopenTrace::rowsOf(Place place) const
{
    const int node = CanopenAddress::of(place.node).node;
    std::vector<CanopenRow> rows;
    for (const Row &one : m_rows)
        if (one.node == 0 || one.node == node)
            rows.push_back(one.row);
    return rows;
}

QString CanopenTrace::text(Place place) const
{
    TextTable table({TextTable::Align::right});
    table.add({QStringLiteral("ms"), CommandLine::tr("direction"), CommandLine::tr("identifier"),
               CommandLine::tr("data"), CommandLine::tr("meaning")});
    CanFrameMeanings meanings;
    for (const CanopenRow &one : rowsOf(place))
        table.add({rowTime(one.frame.time.value_or(Instant())),
                   one.isSent ? CommandLine::tr("sent") : CommandLine::tr("received"),
                   identifierText(one.frame), octetsText(one.frame.data()), meanings.next(one.frame)()});
    return table.toString();
}

QJsonArray CanopenTrace::json(Place place) const
{
    QJsonArray json;
    CanFrameMeanings meanings;
    for (const CanopenRow &one : rowsOf(place)) {
        QJsonObject row = frameJson(one.frame, meanings.next(one.frame)());
        row.insert(QStringLiteral("direction"),
                   one.isSent ? QStringLiteral("sent") : QStringLiteral("received"));
        json.append(row);
    }
    return json;
}

QString identifierText(const CanFrame &frame)
{
    constexpr int digits = 3;
    constexpr int digitsOfExtended = 8;
    return QStringLiteral("%1")
        .arg(frame.id, frame.isExtended || frame.isError ? digitsOfExtended : digits, 16, QLatin1Char('0'))
        .toUpper();
}

QString octetsText(std::span<const std::uint8_t> octets)
{
    return QString::fromLatin1(
        QByteArray(reinterpret_cast<const char *>(octets.data()), static_cast<qsizetype>(octets.size()))
            .toHex(' ')
            .toUpper());
}

} // namespace codewheel
