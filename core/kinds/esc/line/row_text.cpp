// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/row_text.h"

#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/protocol/esc_frame.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

using RowKind = esc::EscLineRow::Kind;

// The translation context of these texts.
struct EscLineRowText
{
    Q_DECLARE_TR_FUNCTIONS(EscLineRowText)
};

QString sentMeaning(const std::optional<esc::Request> &request, const esc::ExplainOptions &options)
{
    return request ? esc::requestText(*request, options) : EscLineRowText::tr("no request of this protocol");
}

QString answerMeaning(const esc::EscLineRow &row, const std::optional<esc::Request> &request,
                      const esc::ExplainOptions &options)
{
    const auto answer = request ? answerIn(row.bytes, request->command) : std::nullopt;
    return answer ? esc::answerText(*request, *answer, options) : EscLineRowText::tr("no well-formed answer");
}

} // namespace

std::optional<esc::Answer> answerIn(const QByteArray &bytes, esc::Command command)
{
    const esc::CommandShape &shape = esc::shapeOf(command);
    if (auto wordless = esc::wordlessAnswer(bytes, shape))
        return wordless;
    const auto frames = esc::valuesIn(bytes, shape);
    if (frames.size() != 1 || frames.front().size() != bytes.size())
        return {};
    return frames.front().answer;
}

bool isAutomatic(esc::Command command)
{
    switch (command) {
    case esc::Command::position:
    case esc::Command::warnings:
    case esc::Command::alarms:
    case esc::Command::serialNumber:
    case esc::Command::version:
    case esc::Command::deviceCode:
        return true;
    default:
        return false;
    }
}

bool PassedRow::isAutomatic() const
{
    const bool isWrong = row.kind == RowKind::garbage || row.kind == RowKind::late;
    return !isWrong && request && codewheel::isAutomatic(request->command);
}

PassedRow passedRow(const esc::EscLineRow &row, std::optional<esc::Request> &lastRequest)
{
    if (row.kind == RowKind::sent)
        lastRequest = sentRequest(row.bytes);
    return {row, lastRequest};
}

QString rowMeaning(const PassedRow &passed, const esc::ExplainOptions &options)
{
    const auto &[row, request] = passed;
    switch (row.kind) {
    case RowKind::sent:
        return sentMeaning(request, options);
    case RowKind::answer:
        return answerMeaning(row, request, options);
    case RowKind::echo:
        return EscLineRowText::tr("what was sent, echoed by the adapter: dropped");
    case RowKind::garbage:
        return request ? sentence(EscLineRowText::tr("no well-formed answer to \"%1\": dropped"),
                                  {esc::requestText(*request, options)})
                       : EscLineRowText::tr("nobody asked for it: dropped");
    case RowKind::late:
        break;
    }
    return EscLineRowText::tr("came after its time-out: dropped");
}

TrafficRow EscLineTraffic::row(const esc::EscLineRow &what)
{
    const PassedRow passed = passedRow(what, m_lastRequest);
    return {.at = what.at,
            .place = passed.request ? std::optional(placeOnLine(passed.request->to)) : std::nullopt,
            .kind = what.kind,
            .bytes = what.bytes,
            .meaning = [passed, options = m_options] { return rowMeaning(passed, *options); },
            .isAutomatic = passed.isAutomatic()};
}

} // namespace codewheel
