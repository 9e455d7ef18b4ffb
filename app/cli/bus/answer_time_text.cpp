// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/answer_time_text.h"

#include "cli/call/texts.h"
#include "vocabulary/sentence.h"

#include <QJsonObject>
#include <QLocale>

namespace codewheel {
namespace {

QString millisecondsText(Instant time)
{
    constexpr double microseconds = 1'000; // a millisecond
    return QLocale().toString(static_cast<double>(time.count()) / microseconds, 'f', 1);
}

} // namespace

QString answerTimeText(const std::optional<AnswerTime> &time)
{
    if (!time)
        return {};
    return sentence(CommandLine::tr("Answer time: %1 ms (median; shortest %2, longest %3)."),
                    {millisecondsText(time->median), millisecondsText(time->shortest),
                     millisecondsText(time->longest)}) +
           u'\n';
}

QJsonValue answerTimeJson(const std::optional<AnswerTime> &time)
{
    if (!time)
        return {};
    return QJsonObject{{QStringLiteral("shortest"), static_cast<qint64>(time->shortest.count())},
                       {QStringLiteral("median"), static_cast<qint64>(time->median.count())},
                       {QStringLiteral("longest"), static_cast<qint64>(time->longest.count())}};
}

QString countText(std::uint64_t count)
{
    return QString::number(count);
}

QJsonValue countJson(std::uint64_t count)
{
    return static_cast<qint64>(count);
}

} // namespace codewheel
