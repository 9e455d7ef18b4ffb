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

// The position of a rod that stands in IN.
std::optional<std::int64_t> rodPosition(const DeviceDescription &device, const Exchange &row)
{
    if (device.profile != Profile::la66)
        return std::nullopt;
    const Meaning meaning = inMeaning(device, row).first();
    const bool isPosition = meaning.id == MeaningId::position || meaning.id == MeaningId::positionWithError;
    return isPosition ? std::optional(meaning.number[0]) : std::nullopt;
}

QString inText(const DeviceDescription &device, const Exchange &row, const std::optional<RodScale> &scale)
{
    const QString text = explanationText(device, inMeaning(device, row));
    const auto position = rodPosition(device, row);
    return scale && position ? QStringLiteral("%1 (%2)").arg(text, scale->text(*position)) : text;
}

} // namespace

QString traceText(const DeviceDescription &device, const std::vector<Exchange> &rows,
                  const std::optional<RodScale> &scale)
{
    TextTable table({TextTable::Align::right});
    if (device.outWords == 0) {
        table.add({CommandLine::tr("cycle"), QStringLiteral("IN"), CommandLine::tr("IN means")});
        for (const Exchange &row : rows)
            table.add({QString::number(row.cycle), hexWord(row.in),
                       explanationText(device, inMeaning(device, row))});
        return table.toString();
    }
    table.add({CommandLine::tr("cycle"), QStringLiteral("OUT"), QStringLiteral("IN"),
               CommandLine::tr("OUT means"), CommandLine::tr("IN means")});
    for (const Exchange &row : rows)
        table.add({QString::number(row.cycle), hexWord(row.out), hexWord(row.in),
                   explanationText(device, outMeaning(device, row)), inText(device, row, scale)});
    return table.toString();
}

QJsonArray traceJson(const DeviceDescription &device, const std::vector<Exchange> &rows,
                     const std::optional<RodScale> &scale)
{
    QJsonArray json;
    for (const Exchange &row : rows) {
        QJsonObject object{{QStringLiteral("cycle"), static_cast<qint64>(row.cycle)},
                           {QStringLiteral("microseconds"), static_cast<qint64>(row.at.count())},
                           {QStringLiteral("out"), wordJson(row.out)},
                           {QStringLiteral("in"), wordJson(row.in)},
                           {QStringLiteral("outMeanings"), meaningsJson(outMeaning(device, row))},
                           {QStringLiteral("inMeanings"), meaningsJson(inMeaning(device, row))}};
        if (device.profile == Profile::la66)
            object.insert(QStringLiteral("millimetres"), millimetresJson(rodPosition(device, row), scale));
        json.append(object);
    }
    return json;
}

} // namespace codewheel
