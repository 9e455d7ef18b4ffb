// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/frame_rows.h"

#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"

#include <QDateTime>

namespace codewheel {
namespace {

constexpr std::int64_t secondOfFrames = 1'000'000;

QString fractionText(std::int64_t microseconds)
{
    constexpr int decimals = 6;
    return QStringLiteral(".%1").arg(microseconds % secondOfFrames, decimals, 10, QLatin1Char('0'));
}

// "2018-12-06 14:31:19.432583", local time; "0.010000", "-0.000100"
QString timeText(Instant time, bool isSince1970)
{
    const std::int64_t microseconds = time.count();
    if (!isSince1970 || microseconds < 0) {
        const QString sign = microseconds < 0 ? QStringLiteral("-") : QString();
        const std::int64_t size = std::abs(microseconds);
        return sign + QString::number(size / secondOfFrames) + fractionText(size);
    }
    return QDateTime::fromSecsSinceEpoch(microseconds / secondOfFrames)
               .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) +
           fractionText(microseconds);
}

QString idText(const CanFrame &frame)
{
    if (frame.isError)
        return CommandLine::tr("error", "in place of an identifier");
    constexpr int digits = 3;
    constexpr int digitsOfExtended = 8;
    return QStringLiteral("%1")
        .arg(frame.id, frame.isExtended ? digitsOfExtended : digits, 16, QLatin1Char('0'))
        .toUpper();
}

QByteArray hexData(const CanFrame &frame, char between = '\0')
{
    const auto data = frame.data();
    return QByteArray::fromRawData(reinterpret_cast<const char *>(data.data()),
                                   static_cast<qsizetype>(data.size()))
        .toHex(between)
        .toUpper();
}

} // namespace

QStringList frameCells(const CanFrame &frame, const QString &meaning, bool isSince1970)
{
    constexpr qsizetype widestData = 23; // of eight bytes
    const QString data =
        frame.isRemote ? QStringLiteral("R%1").arg(frame.length) : QString::fromLatin1(hexData(frame, ' '));
    return {frame.time ? timeText(*frame.time, isSince1970) : orDash({}), idText(frame),
            orDash(data).leftJustified(widestData), meaning};
}

QJsonObject frameJson(const CanFrame &frame, const QString &meaning)
{
    const bool isKnown = !frame.isError || frame.id != 0;
    return {{QStringLiteral("id"), isKnown ? QJsonValue(static_cast<qint64>(frame.id)) : QJsonValue()},
            {QStringLiteral("extended"), frame.isExtended},
            {QStringLiteral("remote"), frame.isRemote},
            {QStringLiteral("error"), frame.isError},
            {QStringLiteral("length"), frame.length},
            {QStringLiteral("data"), QString::fromLatin1(hexData(frame))},
            {QStringLiteral("interface"), textJson(QString::fromStdString(frame.interface))},
            {QStringLiteral("microseconds"),
             frame.time ? QJsonValue(static_cast<qint64>(frame.time->count())) : QJsonValue()},
            {QStringLiteral("meaning"), textJson(meaning)}};
}

QString timesKey(CanLogTimes times)
{
    switch (times) {
    case CanLogTimes::absolute:
        return QStringLiteral("absolute");
    case CanLogTimes::relative:
        return QStringLiteral("relative");
    case CanLogTimes::differences:
        break;
    }
    return QStringLiteral("differences");
}

QString timesText(std::optional<CanLogTimes> times, bool isSince1970)
{
    if (!times)
        return {};
    if (*times == CanLogTimes::differences)
        return isSince1970
                   ? CommandLine::tr("The times of the log are differences; they are shown as local time.")
                   : CommandLine::tr("The times of the log are differences; they are shown since the "
                                     "first frame.");
    return isSince1970 ? CommandLine::tr("The times of the log are absolute; they are shown as local time.")
                       : CommandLine::tr("The times of the log are relative; they are shown since the first "
                                         "frame.");
}

} // namespace codewheel
