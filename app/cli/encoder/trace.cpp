// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/trace.h"

#include "catalog/explain_exchange.h"
#include "catalog/protocol_rules.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "vocabulary/hex.h"

namespace codewheel {
namespace {

ExplainedExchange meanings(const DeviceDescription &device, const Exchange &row, const Exchange *before)
{
    return explainExchange(device, row, askedWord(device, row, before));
}

const Exchange *rowBefore(const std::vector<Exchange> &rows, std::size_t i)
{
    return i > 0 ? &rows[i - 1] : nullptr;
}

// The position of a rod that is in IN.
std::optional<std::int64_t> rodPosition(const DeviceDescription &device, const Explanation &in)
{
    if (!isRod(device))
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

TextTable traceTable()
{
    return TextTable({TextTable::Align::right});
}

QStringList traceHead(const DeviceDescription &device)
{
    if (device.outWords == 0)
        return {CommandLine::tr("cycle"), QStringLiteral("IN"), CommandLine::tr("IN means")};
    return {CommandLine::tr("cycle"), QStringLiteral("OUT"), QStringLiteral("IN"),
            CommandLine::tr("OUT means"), CommandLine::tr("IN means")};
}

QStringList traceCells(const DeviceDescription &device, const Exchange &row, const Exchange *before,
                       const std::optional<RodScale> &scale)
{
    const auto [out, in] = meanings(device, row, before);
    if (device.outWords == 0)
        return {QString::number(row.cycle), hexWord(row.in), explanationText(device, in)};
    return {QString::number(row.cycle), row.outIsKnown ? hexWord(row.out) : QStringLiteral("-"),
            row.isAnswered ? hexWord(row.in) : QStringLiteral("-"),
            row.outIsKnown ? explanationText(device, out) : CommandLine::tr("not known"),
            row.isAnswered ? inText(device, in, scale) : CommandLine::tr("not answered")};
}

QJsonObject traceRowJson(const DeviceDescription &device, const Exchange &row, const Exchange *before,
                         const std::optional<RodScale> &scale)
{
    const auto [out, in] = meanings(device, row, before);
    QJsonObject json{{QStringLiteral("cycle"), static_cast<qint64>(row.cycle)},
                     {QStringLiteral("microseconds"), static_cast<qint64>(row.at.count())},
                     {QStringLiteral("out"), row.outIsKnown ? wordJson(row.out) : QJsonValue()},
                     {QStringLiteral("in"), row.isAnswered ? wordJson(row.in) : QJsonValue()},
                     {QStringLiteral("outMeanings"), row.outIsKnown ? meaningsJson(out) : QJsonArray()},
                     {QStringLiteral("inMeanings"), row.isAnswered ? meaningsJson(in) : QJsonArray()}};
    if (isRod(device))
        json.insert(QStringLiteral("millimetres"), millimetresJson(rodPosition(device, in), scale));
    return json;
}

QString traceText(const DeviceDescription &device, const std::vector<Exchange> &rows,
                  const std::optional<RodScale> &scale)
{
    TextTable table = traceTable();
    table.add(traceHead(device));
    for (std::size_t i = 0; i < rows.size(); ++i)
        table.add(traceCells(device, rows[i], rowBefore(rows, i), scale));
    return table.toString();
}

QJsonArray traceJson(const DeviceDescription &device, const std::vector<Exchange> &rows,
                     const std::optional<RodScale> &scale)
{
    QJsonArray json;
    for (std::size_t i = 0; i < rows.size(); ++i)
        json.append(traceRowJson(device, rows[i], rowBefore(rows, i), scale));
    return json;
}

} // namespace codewheel
