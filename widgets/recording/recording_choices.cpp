// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recording_choices.h"

#include <QJsonArray>

#include <array>

namespace codewheel {
namespace {

constexpr std::array triggerKeys{"atOnce", "bit", "threshold", "fault", "attention", "message"};

QString keyOf(TriggerChoice::Kind kind)
{
    return QLatin1String(triggerKeys.at(static_cast<std::size_t>(kind)));
}

TriggerChoice::Kind triggerKind(const QString &key)
{
    const auto found =
        std::ranges::find_if(triggerKeys, [&](const char *known) { return key == QLatin1String(known); });
    return found == triggerKeys.end() ? TriggerChoice::Kind::atOnce
                                      : static_cast<TriggerChoice::Kind>(found - triggerKeys.begin());
}

const QString busPrefix = QStringLiteral("bus ");

QString keyOfPlace(Place place)
{
    return place.isEmpty() ? busPrefix + QString::number(place.bus.number) : place.key();
}

Place placeFromKey(const QString &key)
{
    if (key.startsWith(busPrefix))
        return {BusId{key.mid(busPrefix.size()).toInt()}, {}};
    return Place::parse(key).value_or(Place());
}

QJsonObject toJson(const TriggerChoice &trigger)
{
    return {{QStringLiteral("kind"), keyOf(trigger.kind)},
            {QStringLiteral("place"), keyOfPlace(trigger.place)},
            {QStringLiteral("channel"), channelKey(trigger.channel)},
            {QStringLiteral("bit"), static_cast<int>(trigger.bit)},
            {QStringLiteral("rising"), trigger.rising},
            {QStringLiteral("value"), trigger.value},
            {QStringLiteral("unit"), unitKey(trigger.unit)}};
}

TriggerChoice triggerChoice(const QJsonObject &json)
{
    const TriggerChoice usual;
    return {.kind = triggerKind(json[u"kind"].toString()),
            .place = placeFromKey(json[u"place"].toString()),
            .channel = channelFromKey(json[u"channel"].toString()).value_or(usual.channel),
            .bit = static_cast<unsigned>(std::clamp(json[u"bit"].toInt(), 0, 31)),
            .rising = json[u"rising"].toBool(usual.rising),
            .value = json[u"value"].toDouble(),
            .unit = trackUnit(json[u"unit"].toString()).value_or(usual.unit)};
}

double asSeconds(Instant time)
{
    return std::chrono::duration<double>(time).count();
}

Instant secondsOf(const QJsonValue &json, Instant usual)
{
    constexpr double longest = 1e9;
    const double seconds = std::clamp(json.toDouble(asSeconds(usual)), 0.0, longest);
    return std::chrono::duration_cast<Instant>(std::chrono::duration<double>(seconds));
}

} // namespace

QJsonObject toJson(const RecordingChoices &choices)
{
    QJsonArray places;
    for (const Place place : choices.places)
        places.append(place.key());
    return {{QStringLiteral("folder"), choices.folder},
            {QStringLiteral("places"), places},
            {QStringLiteral("traffic"), choices.withTraffic},
            {QStringLiteral("trigger"), toJson(choices.trigger)},
            {QStringLiteral("before"), asSeconds(choices.before)},
            {QStringLiteral("after"), asSeconds(choices.after)},
            {QStringLiteral("ends"), choices.endsByItself},
            {QStringLiteral("keptFor"), asSeconds(choices.keptFor)},
            {QStringLiteral("isKeptFor"), choices.isKeptFor},
            {QStringLiteral("size"), choices.largestSize},
            {QStringLiteral("hasSize"), choices.hasLargestSize},
            {QStringLiteral("free"), choices.leastFree}};
}

RecordingChoices recordingChoices(const QJsonObject &json)
{
    const RecordingChoices usual;
    RecordingChoices choices{
        .folder = json[u"folder"].toString(),
        .withTraffic = json[u"traffic"].toBool(usual.withTraffic),
        .trigger = triggerChoice(json[u"trigger"].toObject()),
        .before = secondsOf(json[u"before"], usual.before),
        .after = secondsOf(json[u"after"], usual.after),
        .endsByItself = json[u"ends"].toBool(usual.endsByItself),
        .keptFor = secondsOf(json[u"keptFor"], usual.keptFor),
        .isKeptFor = json[u"isKeptFor"].toBool(usual.isKeptFor),
        .largestSize = json[u"size"].toInt(usual.largestSize),
        .hasLargestSize = json[u"hasSize"].toBool(usual.hasLargestSize),
        .leastFree = json[u"free"].toInt(usual.leastFree),
    };
    for (const QJsonValue &place : json[u"places"].toArray())
        if (const auto parsed = Place::parse(place.toString()))
            choices.places.insert(*parsed);
    return choices;
}

} // namespace codewheel
