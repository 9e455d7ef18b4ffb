// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ring/register_table.h"

#include "catalog/catalog.h"
#include "cli/json.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "modbus/served_ring.h"

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

RegisterBlock asHolding(const RegisterBlock &in)
{
    return {in.first + served_registers::inAsHolding, in.count};
}

} // namespace

QString registerTable(const RingStructure &ring, const Catalog &catalog)
{
    const auto map = servedMap(ring);
    if (!map)
        return {};
    TextTable table;
    table.add({CommandLine::tr("place"), CommandLine::tr("IN, input"), CommandLine::tr("IN, holding"),
               CommandLine::tr("OUT, holding"), CommandLine::tr("device")});
    for (std::size_t i = 0; i < ring.size(); ++i)
        table.add({ring[i].number.toString(), rangeText(map->in(i)), rangeText(asHolding(map->in(i))),
                   rangeText(map->out(i)),
                   participantName(ring[i], catalog.find(ring[i].deviceKey, ring[i].deviceCode))});
    return table.toString();
}

QJsonArray registerJson(const RingStructure &ring)
{
    const auto map = servedMap(ring);
    QJsonArray json;
    for (std::size_t i = 0; map && i < ring.size(); ++i)
        json.append(QJsonObject{{QStringLiteral("place"), ring[i].number.toString()},
                                {QStringLiteral("in"), firstJson(map->in(i))},
                                {QStringLiteral("out"), firstJson(map->out(i))}});
    return json;
}

} // namespace codewheel
