// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_json.h"

#include "journal/message_fields.h"
#include "journal/stored_message.h"
#include "project/project_keys.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/value_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace codewheel {
namespace {

constexpr QLatin1String trendFormat("codewheel-trend");
constexpr int trendVersion = 1;

QDateTime dateTimeOf(Instant at)
{
    return QDateTime::fromMSecsSinceEpoch(std::chrono::floor<std::chrono::milliseconds>(at).count(), Qt::UTC);
}

// "2026-03-01T13:02:03.123456Z"
QString isoText(Instant at)
{
    const auto microseconds = (at - std::chrono::floor<std::chrono::seconds>(at)).count();
    return dateTimeOf(at).toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss.")) +
           QString::number(microseconds).rightJustified(6, u'0') + u'Z';
}

QString isoText(const QDateTime &at)
{
    return at.toUTC().toString(Qt::ISODateWithMs);
}

QJsonValue textOrNull(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

QJsonValue numberOrNull(const std::optional<double> &number)
{
    return number ? QJsonValue(*number) : QJsonValue();
}

void addPlace(QJsonObject &json, const Place &place)
{
    json.insert(QStringLiteral("bus"), place.bus.number);
    json.insert(QStringLiteral("place"), textOrNull(place.toString()));
}

// When something was known within a span, and what is missing of it.
struct KnownTimes
{
    Instant from = Instant::max();
    Instant to = Instant::min(); // older than `from`: nothing was known
    int gaps = 0;
    Instant missing{};

    void leaveOut(const History::Gap &gap, const TimeSpan &span);
};

void KnownTimes::leaveOut(const History::Gap &gap, const TimeSpan &span)
{
    const Instant length = std::min(gap.to, span.to) - std::max(gap.from, span.from);
    if (length <= Instant(0))
        return;
    ++gaps;
    missing += length;
    if (gap.from <= from)
        from = std::max(from, gap.to);
    if (to < gap.to)
        to = std::min(to, gap.from);
}

KnownTimes knownTimes(const History *history, const TimeSpan &span)
{
    const auto all = history != nullptr ? history->span() : std::nullopt;
    if (!all)
        return {};
    KnownTimes known{.from = std::max(all->from, span.from), .to = std::min(all->to - Instant(1), span.to)};
    for (const History::Gap &gap : history->gaps(span))
        known.leaveOut(gap, span);
    return known;
}

// `shift`: without it they are those of the table.
void addKnownTimes(QJsonObject &json, const KnownTimes &known, Instant shift)
{
    const bool isKnown = known.from <= known.to;
    json.insert(QStringLiteral("knownFrom"), textOrNull(isKnown ? isoText(known.from - shift) : QString()));
    json.insert(QStringLiteral("knownTo"), textOrNull(isKnown ? isoText(known.to - shift) : QString()));
    json.insert(QStringLiteral("gaps"), known.gaps);
    json.insert(QStringLiteral("gapSeconds"), std::chrono::duration<double>(known.missing).count());
}

// Of a speed: of one step per second.
double perStepOf(Channel channel, const TrackScale &scale)
{
    return scale.factor(channel) * (channel == Channel::speed ? speedUnits : 1);
}

// What a step was before, within the span; the times are those of the table.
QJsonArray earlierJson(const TrendExtract &extract, const TrendColumn &column)
{
    QJsonArray all;
    for (const TrackScale::Earlier &earlier : column.scale.earlier)
        if (earlier.until > extract.span.from)
            all.append(QJsonObject{{QStringLiteral("until"), isoText(earlier.until - extract.commonShift())},
                                   {QStringLiteral("perStep"),
                                    perStepOf(column.track.channel, {column.scale.unit, earlier.perStep})}});
    return all;
}

double secondsOf(Instant duration)
{
    return std::chrono::duration<double>(duration).count();
}

QJsonObject columnJson(const TrendExtract &extract, const TrendColumn &column)
{
    const Track &track = column.track;
    const QLatin1String unit = column.scale.symbol(track.channel);
    QJsonObject json{
        {QStringLiteral("name"), extract.title(column)},
        {QStringLiteral("shiftSeconds"), secondsOf(extract.remainingShift(column))},
        {QStringLiteral("track"), track.key()},
        {QStringLiteral("channel"), channelKey(track.channel)},
        {QStringLiteral("bit"), track.bit ? QJsonValue(static_cast<int>(*track.bit)) : QJsonValue()},
        {QStringLiteral("unit"), textOrNull(unit)},
        {QStringLiteral("perStep"),
         unit.isEmpty() ? QJsonValue() : QJsonValue(perStepOf(track.channel, column.scale))},
        {QStringLiteral("earlierScales"), unit.isEmpty() ? QJsonArray() : earlierJson(extract, column)}};
    addPlace(json, track.place);
    return json;
}

QJsonArray columnsJson(const TrendExtract &extract, const HistoryOf &historyOf)
{
    QJsonArray columns;
    for (const TrendColumn &column : extract.columns) {
        QJsonObject json = columnJson(extract, column);
        addKnownTimes(json, knownTimes(historyOf(column.track), extract.span), extract.commonShift());
        columns.append(json);
    }
    return columns;
}

QJsonValue evidenceJson(const std::optional<Evidence> &evidence)
{
    return evidence ? QJsonValue(QLatin1String(project_keys::nameOf(project_keys::evidences, *evidence)))
                    : QJsonValue();
}

QJsonArray valuesJson(const std::vector<TrendValue> &values)
{
    QJsonArray json;
    for (const TrendValue &value : values)
        json.append(QJsonObject{{QStringLiteral("parameter"), parameterKey(value.parameter)},
                                {QStringLiteral("value"), valueToJson(value.value)},
                                {QStringLiteral("evidence"), evidenceJson(value.evidence)},
                                {QStringLiteral("at"), isoText(value.at)}});
    return json;
}

QJsonArray encodersJson(const TrendExtract &extract, const std::vector<TrendEncoder> &encoders)
{
    QJsonArray all;
    for (const TrendEncoder &encoder : encoders) {
        if (std::ranges::none_of(extract.columns, [&](const TrendColumn &column) {
                return column.track.place == encoder.place;
            }))
            continue;
        QJsonObject json{{QStringLiteral("busName"), textOrNull(encoder.busName)},
                         {QStringLiteral("station"), textOrNull(encoder.station)},
                         {QStringLiteral("device"), textOrNull(encoder.device)},
                         {QStringLiteral("deviceName"), textOrNull(encoder.deviceName)},
                         {QStringLiteral("stepsPerTurn"), numberOrNull(encoder.stepsPerTurn)},
                         {QStringLiteral("values"), valuesJson(encoder.values)}};
        addPlace(json, encoder.place);
        all.append(json);
    }
    return all;
}

QJsonObject messageJson(const Message &message)
{
    return {{QStringLiteral("kind"), QStringLiteral("message")},
            {QStringLiteral("severity"), severityKey(message.severity)},
            {QStringLiteral("code"), codeOf(storedMessage(message, {}))},
            {QStringLiteral("text"), messageText(message)}};
}

QJsonObject noteJson(const QString &text)
{
    return {{QStringLiteral("kind"), QStringLiteral("note")}, {QStringLiteral("text"), text}};
}

// What other buses said then was at another time than what a shifted recording has.
bool isOfTable(const Mark &mark, const TrendExtract &extract)
{
    if (mark.at < extract.span.from || mark.at > extract.span.to)
        return false;
    return !mark.place || extract.commonShift() == Instant() ||
           std::ranges::any_of(extract.columns, [&mark](const TrendColumn &column) {
               return column.track.place.bus == mark.place->bus;
           });
}

QJsonArray marksJson(const std::deque<Mark> &marks, const TrendExtract &extract)
{
    QJsonArray all;
    for (const Mark &mark : marks) {
        if (!isOfTable(mark, extract))
            continue;
        const auto *const note = std::get_if<QString>(&mark.what);
        QJsonObject json = note != nullptr ? noteJson(*note) : messageJson(std::get<Message>(mark.what));
        json.insert(QStringLiteral("at"), isoText(mark.at - extract.commonShift()));
        if (mark.place)
            addPlace(json, *mark.place);
        all.append(json);
    }
    return all;
}

QJsonValue dateColumnJson(const CsvStyle &style)
{
    const std::string title = style.dateTitle();
    return title.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(title));
}

// The offset is that at the beginning; the clocks may be changed later.
QJsonObject zoneJson(const QTimeZone &zone, Instant from)
{
    const QDateTime local = dateTimeOf(from).toTimeZone(zone);
    return {{QStringLiteral("id"), QString::fromLatin1(zone.id())},
            {QStringLiteral("offsetSeconds"), local.offsetFromUtc()}};
}

} // namespace

QByteArray trendJson(const TrendTable &table, const HistoryOf &historyOf, const TrendOrigin &origin)
{
    const auto &[fileName, extract, style, rows] = table;
    const Instant shift = extract.commonShift();
    const Instant from = extract.span.from - shift;
    const QJsonObject json{{QStringLiteral("format"), trendFormat},
                           {QStringLiteral("version"), trendVersion},
                           {QStringLiteral("program"), QStringLiteral("Codewheel ") + origin.version},
                           {QStringLiteral("written"), isoText(origin.now)},
                           {QStringLiteral("file"), fileName},
                           {QStringLiteral("rows"), rows},
                           {QStringLiteral("separator"), QString(QLatin1Char(style.separator))},
                           {QStringLiteral("decimalSign"), QString::fromStdString(style.decimalSign)},
                           {QStringLiteral("timeColumn"), QString::fromStdString(style.timeTitle())},
                           {QStringLiteral("dateColumn"), dateColumnJson(style)},
                           {QStringLiteral("from"), isoText(from)},
                           {QStringLiteral("to"), isoText(extract.span.to - shift)},
                           {QStringLiteral("shownLaterSeconds"), secondsOf(shift)},
                           {QStringLiteral("timeZone"), zoneJson(origin.now.timeZone(), from)},
                           {QStringLiteral("columns"), columnsJson(extract, historyOf)},
                           {QStringLiteral("encoders"), encodersJson(extract, origin.encoders)},
                           {QStringLiteral("marks"), marksJson(origin.marks, extract)},
                           {QStringLiteral("dropped"), static_cast<qint64>(origin.dropped)}};
    return QJsonDocument(json).toJson();
}

bool isTrendJson(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object().value(QStringLiteral("format")) == QJsonValue(trendFormat);
}

} // namespace codewheel
