// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recording_texts.h"

#include "journal/message_fields.h"
#include "recording/recording_growth.h"
#include "widgets/trend/ticks.h"
#include "widgets/trend/track_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel {
namespace {

struct RecordingTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RecordingTexts)
};

constexpr double secondsPerHour = 3'600;
constexpr double leastRate = 0.01; // bytes per second: nothing moves

Instant lasting(double seconds)
{
    constexpr double longest = 1e9;
    return std::min(RecordingGrowth::longest,
                    std::chrono::duration_cast<Instant>(
                        std::chrono::duration<double>(std::clamp(seconds, 0.0, longest))));
}

QString enoughText(const RecordingRoom &room, double rate)
{
    const QLocale locale;
    const auto until = [&](std::int64_t bytes) {
        return roughDurationText(lasting(static_cast<double>(bytes) / rate), locale);
    };
    const std::int64_t left = room.free - room.leastFree;
    const double ofRing = rate * std::chrono::duration<double>(room.keptFor).count();
    if (room.keptFor > Instant(0) && ofRing < static_cast<double>(left) &&
        (room.largestSize == 0 || ofRing < static_cast<double>(room.largestSize)))
        return RecordingTexts::tr("At the present rate %1 need about %2: the disk does not get full.")
            .arg(roughDurationText(room.keptFor, locale), sizeText(static_cast<std::int64_t>(ofRing)));
    const QString hourly = sizeText(static_cast<std::int64_t>(rate * secondsPerHour));
    if (room.largestSize > 0 && room.largestSize < left)
        return RecordingTexts::tr("At the present rate, about %1 an hour, it has its largest size after %2; "
                                  "from then on the oldest gives way.")
            .arg(hourly, until(room.largestSize));
    return RecordingTexts::tr("At the present rate, about %1 an hour, that is enough for %2.")
        .arg(hourly, until(left));
}

struct TriggerTexts
{
    QString operator()(const BitTrigger &trigger) const
    {
        const QString what = trackText({trigger.place, trigger.channel, trigger.bit});
        return (trigger.rising ? RecordingTexts::tr("%1: %2 becomes 1", "place, bit")
                               : RecordingTexts::tr("%1: %2 becomes 0", "place, bit"))
            .arg(trigger.place.shown(), what);
    }
    QString operator()(const ThresholdTrigger &trigger) const
    {
        const TrackScale steps;
        const double value = static_cast<double>(trigger.threshold) * steps.factor(trigger.channel);
        return (trigger.rising
                    ? RecordingTexts::tr("%1: %2 rises to %3", "place, value, number with unit")
                    : RecordingTexts::tr("%1: %2 falls below %3", "place, value, number with unit"))
            .arg(trigger.place.shown(), trackText({trigger.place, trigger.channel, {}}),
                 QStringLiteral("%1 %2").arg(QLocale().toString(value, 'f', 0),
                                             unitSymbol(steps, trigger.channel)));
    }
    QString operator()(const MessageTrigger &trigger) const
    {
        const QString what = trigger.least == Severity::fault ? RecordingTexts::tr("a fault")
                             : trigger.least == Severity::attention
                                 ? RecordingTexts::tr("a message of attention, or a fault")
                                 : RecordingTexts::tr("a message");
        return trigger.place ? QStringLiteral("%1: %2").arg(placeName(trigger.place), what) : what;
    }
};

} // namespace

QString sizeText(std::int64_t bytes)
{
    return bytes < 1'000 ? QStringLiteral("0 kB")
                         : QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
}

QString countedText(Instant duration)
{
    constexpr qint64 sixty = 60;
    const auto seconds =
        std::max<qint64>(0, std::chrono::duration_cast<std::chrono::seconds>(duration).count());
    const auto twoDigits = [](qint64 number) {
        return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0'));
    };
    return QStringLiteral("%1:%2:%3")
        .arg(QString::number(seconds / sixty / sixty), twoDigits(seconds / sixty % sixty),
             twoDigits(seconds % sixty));
}

QString triggerText(const RecordingTrigger &trigger)
{
    return std::visit(TriggerTexts(), trigger);
}

QString roomText(const RecordingRoom &room)
{
    const QString free = RecordingTexts::tr("Free on this disk: %1.").arg(sizeText(room.free));
    const auto with = [&](const QString &more) { return QStringLiteral("%1 %2").arg(free, more); };
    if (!room.isEnough())
        return with(RecordingTexts::tr("That is less than is to stay free: nothing would be written."));
    if (!room.bytesPerSecond)
        return with(
            RecordingTexts::tr("How long it is enough is not known until encoders have shown something."));
    if (*room.bytesPerSecond < leastRate)
        return with(RecordingTexts::tr("Nothing changes at present, so next to nothing is needed."));
    return with(enoughText(room, *room.bytesPerSecond));
}

} // namespace codewheel
