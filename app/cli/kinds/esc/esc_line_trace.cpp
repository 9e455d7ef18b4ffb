// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_trace.h"

#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/protocol/esc_bits.h"

namespace codewheel {
namespace {

using Kind = esc::EscLineRow::Kind;

constexpr NamedValue<Kind> rowKindKeys[] = {
    {"sent", Kind::sent},       {"answer", Kind::answer}, {"echo", Kind::echo},
    {"garbage", Kind::garbage}, {"late", Kind::late},
};
constexpr NamedValue<esc::Answer::Kind> answerKindKeys[] = {
    {"value", esc::Answer::Kind::value},           {"text", esc::Answer::Kind::text},
    {"accepted", esc::Answer::Kind::accepted},     {"unknownCommand", esc::Answer::Kind::unknownCommand},
    {"outOfRange", esc::Answer::Kind::outOfRange},
};

} // namespace

EscLineTrace::EscLineTrace(EscLineSession &line)
{
    connect(&line, &EscLineSession::passed, this, [this](const esc::EscLineRow &row) {
        PassedRow passed = passedRow(row, m_request);
        if (!passed.isPoll())
            m_rows.push_back(std::move(passed));
    });
}

QString lineTraceText(const std::vector<PassedRow> &rows, const esc::ExplainOptions &options)
{
    TextTable table({TextTable::Align::right});
    table.add({QStringLiteral("ms"), CommandLine::tr("direction"), CommandLine::tr("bytes"),
               CommandLine::tr("meaning")});
    for (const PassedRow &passed : rows)
        table.add({rowTime(passed.row.at), rowKindWord(passed.row.kind),
                   controlText(passed.row.bytes, ControlCharacters::numbers), rowMeaning(passed, options)});
    return table.toString();
}

QJsonArray bitsJson(esc::Command command, std::uint16_t word)
{
    QJsonArray bits;
    for (const esc::BitRow &bit : esc::bitsOf(command))
        if ((word >> bit.bit & 1U) != 0)
            bits.append(QString::fromLatin1(bit.key));
    return bits;
}

QJsonObject requestJson(const esc::Request &request)
{
    const esc::CommandShape &shape = esc::shapeOf(request.command);
    return {{QStringLiteral("address"), request.to.onWire()},
            {QStringLiteral("letters"),
             QString::fromLatin1(shape.letters.data(), static_cast<qsizetype>(shape.letters.size()))},
            {QStringLiteral("data"),
             shape.writes ? QJsonValue(static_cast<qint64>(request.data)) : QJsonValue()}};
}

QJsonObject answerJson(const esc::Request &request, const esc::Answer &answer,
                       const esc::ExplainOptions &options)
{
    QJsonObject json{{QStringLiteral("answer"), keyOf(answerKindKeys, answer.kind)}};
    if (answer.kind == esc::Answer::Kind::text)
        json.insert(QStringLiteral("version"), QString::fromLatin1(answer.text));
    if (answer.kind != esc::Answer::Kind::value)
        return json;
    json.insert(QStringLiteral("value"), static_cast<qint64>(answer.value));
    const bool isSwapped = options.swaps(request.to) && request.command == esc::Command::warnings;
    const auto word = static_cast<std::uint16_t>(answer.value);
    if (!esc::bitsOf(request.command).empty())
        json.insert(QStringLiteral("bits"),
                    bitsJson(request.command, isSwapped ? esc::swappedBytes(word) : word));
    return json;
}

QJsonObject rowJson(const PassedRow &passed, const esc::ExplainOptions &options)
{
    QJsonObject json{{QStringLiteral("microseconds"), static_cast<qint64>(passed.row.at.count())},
                     {QStringLiteral("direction"), keyOf(rowKindKeys, passed.row.kind)},
                     {QStringLiteral("bytes"), byteText(passed.row.bytes)},
                     {QStringLiteral("text"), controlText(passed.row.bytes, ControlCharacters::numbers)}};
    if (!passed.request)
        return json;
    merge(json, requestJson(*passed.request));
    if (passed.row.kind == Kind::answer)
        if (const auto answer = answerIn(passed.row.bytes, passed.request->command))
            merge(json, answerJson(*passed.request, *answer, options));
    return json;
}

QJsonArray lineTraceJson(const std::vector<PassedRow> &rows, const esc::ExplainOptions &options)
{
    QJsonArray json;
    for (const PassedRow &row : rows)
        json.append(rowJson(row, options));
    return json;
}

} // namespace codewheel
