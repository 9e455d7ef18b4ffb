// SPDX-License-Identifier: GPL-3.0-or-later
#include "esc_line/row_text.h"

#include "encoder/sentence.h"
#include "esc/esc_frame.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

using RowKind = esc::LineRow::Kind;

// The context of these texts.
struct LineRowText
{
    Q_DECLARE_TR_FUNCTIONS(LineRowText)
};

constexpr uchar firstPrintable = 0x20;
constexpr uchar deleteCharacter = 0x7F;
constexpr char16_t controlPictures = 0x2400; // of 00h, then one after the other
constexpr char16_t deletePicture = 0x2421;

QString sentMeaning(const std::optional<esc::Request> &request, const esc::ExplainOptions &options)
{
    return request ? esc::requestText(*request, options) : LineRowText::tr("no request of this protocol");
}

QString answerMeaning(const esc::LineRow &row, const std::optional<esc::Request> &request,
                      const esc::ExplainOptions &options)
{
    const auto answer = request ? answerIn(row.bytes, request->command) : std::nullopt;
    return answer ? esc::answerText(*request, *answer, options) : LineRowText::tr("no well-formed answer");
}

} // namespace

QString controlText(const QByteArray &bytes, ControlCharacters controls)
{
    const bool asPictures = controls == ControlCharacters::pictures;
    QString text;
    for (const char byte : bytes) {
        const auto code = static_cast<uchar>(byte);
        if (code < firstPrintable && asPictures)
            text += QChar(static_cast<char16_t>(controlPictures + code));
        else if (code == deleteCharacter && asPictures)
            text += QChar(deletePicture);
        else if (code < firstPrintable || code >= deleteCharacter)
            text += QStringLiteral("<%1>").arg(byteText(QByteArray(1, byte)));
        else
            text += QLatin1Char(byte);
    }
    return text;
}

QString byteText(const QByteArray &bytes)
{
    return QString::fromLatin1(bytes.toHex(' ').toUpper());
}

QString rowKindWord(RowKind kind)
{
    switch (kind) {
    case RowKind::sent:
        return LineRowText::tr("sent");
    case RowKind::answer:
        return LineRowText::tr("answer");
    case RowKind::echo:
        return LineRowText::tr("echo");
    case RowKind::garbage:
        return LineRowText::tr("garbage");
    case RowKind::late:
        break;
    }
    return LineRowText::tr("late");
}

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

QString rowMeaning(const esc::LineRow &row, const std::optional<esc::Request> &request,
                   const esc::ExplainOptions &options)
{
    switch (row.kind) {
    case RowKind::sent:
        return sentMeaning(request, options);
    case RowKind::answer:
        return answerMeaning(row, request, options);
    case RowKind::echo:
        return LineRowText::tr("what was sent, echoed by the adapter: dropped");
    case RowKind::garbage:
        return request ? sentence(LineRowText::tr("no well-formed answer to \"%1\": dropped"),
                                  {esc::requestText(*request, options)})
                       : LineRowText::tr("nobody asked for it: dropped");
    case RowKind::late:
        break;
    }
    return LineRowText::tr("came after its time-out: dropped");
}

} // namespace codewheel
