// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/register_table.h"

#include "catalog/catalog.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "kinds/interbus/gateway/served_table.h"
#include "kinds/interbus/ring/id_code.h"

#include <QJsonObject>

namespace codewheel {
namespace {

// "0, 1"; "-": it has no words in this direction.
QString rangeText(const RegisterBlock &block)
{
    if (block.count == 0)
        return QStringLiteral("-");
    if (block.count == 1)
        return QString::number(block.first);
    return QStringLiteral("%1, %2").arg(block.first).arg(block.first + 1);
}

QJsonValue firstJson(const RegisterBlock &block)
{
    return block.count == 0 ? QJsonValue() : QJsonValue(block.first);
}

} // namespace

QString registerTable(const RingStructure &ring, const Catalog &catalog)
{
    const auto rows = servedTable(ring);
    if (rows.empty())
        return {};
    TextTable table;
    table.add({CommandLine::tr("place"), CommandLine::tr("IN, input"), CommandLine::tr("IN, holding"),
               CommandLine::tr("OUT, holding"), CommandLine::tr("device")});
    for (std::size_t i = 0; i < rows.size(); ++i)
        table.add({rows[i].place.toString(), rangeText(rows[i].in), rangeText(rows[i].inHolding),
                   rangeText(rows[i].out),
                   nameOrTerminal(ring[i], catalog.find(ring[i].deviceKey, ring[i].deviceCode))});
    return table.toString();
}

QJsonArray registerJson(const RingStructure &ring)
{
    QJsonArray json;
    for (const ServedRegisters &row : servedTable(ring))
        json.append(QJsonObject{{QStringLiteral("place"), row.place.toString()},
                                {QStringLiteral("in"), firstJson(row.in)},
                                {QStringLiteral("out"), firstJson(row.out)}});
    return json;
}

} // namespace codewheel
