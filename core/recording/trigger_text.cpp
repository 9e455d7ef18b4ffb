// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trigger_text.h"

#include "history/track.h"
#include "journal/message_fields.h"

#include <cmath>

namespace codewheel {
namespace {

constexpr QLatin1String busPrefix("bus:");
constexpr double fastestThreshold = 1e12; // steps a second; far beyond any encoder, and exact in a double

// What follows the place.
using ParsedTrigger = tl::expected<RecordingTrigger, TriggerFault>;
using ParsedThreshold = tl::expected<std::int64_t, TriggerFault>;

tl::unexpected<TriggerFault> faulty(TriggerFault fault)
{
    return tl::unexpected(fault);
}

ParsedThreshold thresholdOf(Channel channel, const QString &text)
{
    bool isNumber = false;
    if (channel != Channel::speed) {
        const qint64 steps = text.toLongLong(&isNumber);
        return isNumber ? ParsedThreshold(steps) : faulty(TriggerFault::number);
    }
    const double speed = text.toDouble(&isNumber); // of the C locale
    if (!isNumber || !(std::abs(speed) <= fastestThreshold))
        return faulty(TriggerFault::number);
    return std::llround(speed * speedUnits);
}

// "position>1000"
ParsedTrigger thresholdAt(Place place, const QString &text, qsizetype sign)
{
    const auto channel = channelFromKey(QStringView(text).first(sign));
    if (!channel)
        return faulty(TriggerFault::channel);
    if (bitCount(*channel) > 0)
        return faulty(TriggerFault::form);
    return thresholdOf(*channel, text.sliced(sign + 1)).map([&](std::int64_t threshold) {
        return RecordingTrigger(ThresholdTrigger{place, *channel, threshold, text[sign] == u'>'});
    });
}

// "in.25", "in.25=0"
ParsedTrigger bitAt(Place place, const QString &text)
{
    const qsizetype sign = text.indexOf(u'=');
    const QString name = text.left(sign);
    const QString value = sign < 0 ? QStringLiteral("1") : text.sliced(sign + 1);
    const auto channel = channelFromKey(name.section(u'.', 0, 0));
    if (!channel)
        return faulty(TriggerFault::channel);
    if (bitCount(*channel) == 0 || !name.contains(u'.') ||
        (value != QStringLiteral("0") && value != QStringLiteral("1")))
        return faulty(TriggerFault::form);
    const auto track = Track::parse(QString(place.key() + u'/' + name));
    if (!track)
        return faulty(TriggerFault::bit);
    return RecordingTrigger(BitTrigger{place, *channel, *track->bit, value == QStringLiteral("1")});
}

ParsedTrigger triggerAt(Place place, const QString &text)
{
    if (const auto severity = severityFromKey(text))
        return RecordingTrigger(MessageTrigger{place, *severity});
    if (place.isEmpty())
        return faulty(TriggerFault::place);
    const auto isSign = [](QChar character) { return character == u'>' || character == u'<'; };
    const auto sign = std::ranges::find_if(text, isSign);
    return sign == text.end() ? bitAt(place, text) : thresholdAt(place, text, sign - text.begin());
}

QString speedKey(std::int64_t thousandths)
{
    QString text = QString::number(static_cast<double>(thousandths) / speedUnits, 'f', 3);
    while (text.endsWith(u'0'))
        text.chop(1);
    return text.endsWith(u'.') ? text.chopped(1) : text;
}

struct TriggerKey
{
    QString operator()(const BitTrigger &trigger) const
    {
        const QString key = Track{trigger.place, trigger.channel, trigger.bit}.key();
        return trigger.rising ? key : key + QStringLiteral("=0");
    }
    QString operator()(const ThresholdTrigger &trigger) const
    {
        const bool isSpeed = trigger.channel == Channel::speed;
        return Track{trigger.place, trigger.channel, {}}.key() + (trigger.rising ? u'>' : u'<') +
               (isSpeed ? speedKey(trigger.threshold) : QString::number(trigger.threshold));
    }
    QString operator()(const MessageTrigger &trigger) const
    {
        QString severity = severityKey(trigger.least);
        if (!trigger.place)
            return severity;
        const QString place = trigger.place->isEmpty()
                                  ? busPrefix + QString::number(trigger.place->bus.number)
                                  : trigger.place->key();
        return place + u'/' + severity;
    }
};

} // namespace

QString triggerKey(const RecordingTrigger &trigger)
{
    return std::visit(TriggerKey(), trigger);
}

std::optional<Place> triggerPlace(const QString &text)
{
    if (!text.startsWith(busPrefix))
        return Place::parse(text);
    const int number = text.sliced(busPrefix.size()).toInt();
    return number > 0 ? std::optional(Place{{number}, {}}) : std::nullopt;
}

ParsedTrigger parseTrigger(const QString &text,
                           const std::function<std::optional<Place>(const QString &text)> &placeOf)
{
    const qsizetype slash = text.lastIndexOf(u'/');
    if (slash < 0) {
        const auto severity = severityFromKey(text);
        return severity ? ParsedTrigger(MessageTrigger{{}, *severity}) : faulty(TriggerFault::form);
    }
    const auto place = placeOf(text.first(slash));
    return place ? triggerAt(*place, text.sliced(slash + 1)) : faulty(TriggerFault::place);
}

} // namespace codewheel
