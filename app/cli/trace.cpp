// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trace.h"

#include "catalog/explain_exchange.h"
#include "cli/json.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/asked_word.h"
#include "encoder/hex.h"

namespace codewheel {
namespace {

ExplainedExchange meanings(const DeviceDescription &device, const std::vector<Exchange> &rows, std::size_t i)
{
    return explainExchange(device, rows[i], askedWord(rows[i], i > 0 ? &rows[i - 1] : nullptr));
}

// The position of a rod that is in IN.
std::optional<std::int64_t> rodPosition(const DeviceDescription &device, const Explanation &in)
{
    if (device.profile != Profile::la66)
        return std::nullopt;
    const Meaning &meaning = in.first();
    const bool isPosition = meaning.id == MeaningId::position || meaning.id == MeaningId::positionWithError;
    return isPosition ? std::optional(meaning.number[0]) : std::nullopt;
}

QString inText(const DeviceDescription &device, const Explanation &in, const std::optional<RodScale> &scale)
{
    const QString text = explanationText(device, in);
    const auto position = rodPosition(device, in);
    return scale && position ? QStringLiteral("%1 (%2)").arg(text, scale->text(*position)) : text;
}

} // namespace

QString traceText(const DeviceDescription &device, const std::vector<Exchange> &rows,
                  const std::optional<RodScale> &scale)
{
    TextTable table({TextTable::Align::right});
    if (device.outWords == 0) {
        table.add({CommandLine::tr("cycle"), QStringLiteral("IN"), CommandLine::tr("IN means")});
        for (std::size_t i = 0; i < rows.size(); ++i)
            table.add({QString::number(rows[i].cycle), hexWord(rows[i].in),
                       explanationText(device, meanings(device, rows, i).in)});
        return table.toString();
    }
    table.add({CommandLine::tr("cycle"), QStringLiteral("OUT"), QStringLiteral("IN"),
               CommandLine::tr("OUT means"), CommandLine::tr("IN means")});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Exchange &row = rows[i];
        const auto [out, in] = meanings(device, rows, i);
        table.add({QString::number(row.cycle), hexWord(row.out), hexWord(row.in),
                   explanationText(device, out), inText(device, in, scale)});
    }
    return table.toString();
}

QJsonArray traceJson(const DeviceDescription &device, const std::vector<Exchange> &rows,
                     const std::optional<RodScale> &scale)
{
    QJsonArray json;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Exchange &row = rows[i];
        const auto [out, in] = meanings(device, rows, i);
        QJsonObject object{{QStringLiteral("cycle"), static_cast<qint64>(row.cycle)},
                           {QStringLiteral("microseconds"), static_cast<qint64>(row.at.count())},
                           {QStringLiteral("out"), wordJson(row.out)},
                           {QStringLiteral("in"), wordJson(row.in)},
                           {QStringLiteral("outMeanings"), meaningsJson(out)},
                           {QStringLiteral("inMeanings"), meaningsJson(in)}};
        if (device.profile == Profile::la66)
            object.insert(QStringLiteral("millimetres"), millimetresJson(rodPosition(device, in), scale));
        json.append(object);
    }
    return json;
}

} // namespace codewheel
