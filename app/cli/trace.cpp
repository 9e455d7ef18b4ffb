// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trace.h"

#include "catalog/explain_word.h"
#include "cli/json.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/hex.h"

namespace codewheel {
namespace {

Explanation outMeaning(const DeviceDescription &device, const Exchange &row)
{
    return explainWord(
        device, row.out,
        {.direction = WordDirection::out, .mode = row.mode, .coding = row.coding, .counterpart = row.in});
}

Explanation inMeaning(const DeviceDescription &device, const Exchange &row)
{
    return explainWord(
        device, row.in,
        {.direction = WordDirection::in, .mode = row.mode, .coding = row.coding, .counterpart = row.out});
}

} // namespace

QString traceText(const DeviceDescription &device, const std::vector<Exchange> &rows)
{
    TextTable table({TextTable::Align::right});
    table.add({CommandLine::tr("cycle"), QStringLiteral("OUT"), QStringLiteral("IN"),
               CommandLine::tr("OUT means"), CommandLine::tr("IN means")});
    for (const Exchange &row : rows)
        table.add({QString::number(row.cycle), hexWord(row.out), hexWord(row.in),
                   explanationText(device, outMeaning(device, row)),
                   explanationText(device, inMeaning(device, row))});
    return table.toString();
}

QJsonArray traceJson(const DeviceDescription &device, const std::vector<Exchange> &rows)
{
    QJsonArray json;
    for (const Exchange &row : rows)
        json.append(QJsonObject{{QStringLiteral("cycle"), static_cast<qint64>(row.cycle)},
                                {QStringLiteral("microseconds"), static_cast<qint64>(row.at.count())},
                                {QStringLiteral("out"), wordJson(row.out)},
                                {QStringLiteral("in"), wordJson(row.in)},
                                {QStringLiteral("outMeanings"), meaningsJson(outMeaning(device, row))},
                                {QStringLiteral("inMeanings"), meaningsJson(inMeaning(device, row))}});
    return json;
}

} // namespace codewheel
