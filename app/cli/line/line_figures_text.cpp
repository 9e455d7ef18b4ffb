// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/line/line_figures_text.h"

#include "cli/texts.h"
#include "encoder/sentence.h"

#include <QLocale>

namespace codewheel {
namespace {

QString number(std::uint64_t value)
{
    return QString::number(value);
}

QString millisecondsText(Instant time)
{
    constexpr double microseconds = 1'000; // a millisecond
    return QLocale().toString(static_cast<double>(time.count()) / microseconds, 'f', 1);
}

} // namespace

QString figuresText(const LineFigures &figures)
{
    QString text =
        sentence(CommandLine::tr("Requests: %1. Answers: %2. Time-outs: %3. Retries: %4. Not answered: %5. "
                                 "Garbage bytes: %6. Late bytes: %7."),
                 {number(figures.requests), number(figures.answers), number(figures.timeOuts),
                  number(figures.retries), number(figures.unanswered), number(figures.garbageBytes),
                  number(figures.lateBytes)}) +
        u'\n';
    if (figures.answerTime)
        text += sentence(CommandLine::tr("Answer time: %1 ms (median; shortest %2, longest %3)."),
                         {millisecondsText(figures.answerTime->median),
                          millisecondsText(figures.answerTime->shortest),
                          millisecondsText(figures.answerTime->longest)}) +
                u'\n';
    return text;
}

QJsonObject figuresJson(const LineFigures &figures)
{
    const auto count = [](std::uint64_t value) { return QJsonValue(static_cast<qint64>(value)); };
    QJsonObject json{{QStringLiteral("requests"), count(figures.requests)},
                     {QStringLiteral("answers"), count(figures.answers)},
                     {QStringLiteral("timeOuts"), count(figures.timeOuts)},
                     {QStringLiteral("retries"), count(figures.retries)},
                     {QStringLiteral("unanswered"), count(figures.unanswered)},
                     {QStringLiteral("garbageBytes"), count(figures.garbageBytes)},
                     {QStringLiteral("lateBytes"), count(figures.lateBytes)},
                     {QStringLiteral("answerTime"), QJsonValue()}};
    if (figures.answerTime)
        json[QStringLiteral("answerTime")] = QJsonObject{
            {QStringLiteral("shortest"), static_cast<qint64>(figures.answerTime->shortest.count())},
            {QStringLiteral("median"), static_cast<qint64>(figures.answerTime->median.count())},
            {QStringLiteral("longest"), static_cast<qint64>(figures.answerTime->longest.count())}};
    return json;
}

} // namespace codewheel
