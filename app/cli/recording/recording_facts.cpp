// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/recording_facts.h"

#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "history/rough_duration.h"
#include "history/track.h"
#include "recording/server_address.h"
#include "vocabulary/local_time.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

QDateTime dateTimeOf(Instant at)
{
    return QDateTime::fromMSecsSinceEpoch(std::chrono::floor<std::chrono::milliseconds>(at).count());
}

// By the clock of the bus, as all times in the file; microseconds.
QJsonValue timeJson(Instant at)
{
    const auto micros =
        ((at % std::chrono::milliseconds(1)) + std::chrono::milliseconds(1)) % std::chrono::milliseconds(1);
    return dateTimeOf(at).toUTC().toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss.zzz")) +
           QStringLiteral("%1Z").arg(micros.count(), 3, 10, QLatin1Char('0'));
}

Result<std::optional<RecordingFacts::Encoder>> encoderOf(const RecordingReader &reader,
                                                         const RecordingReader::Device &device)
{
    const auto descriptions = reader.descriptions(device);
    if (!descriptions)
        return tl::unexpected(descriptions.error());
    RecordingFacts::Encoder encoder{.place = device.place, .device = {}, .span = {Instant::max(), {}}};
    for (const RecordingReader::Description &one : *descriptions)
        encoder.described.emplace_back(one.since, recordedDeviceFromJson(one.json));
    if (!encoder.described.empty())
        encoder.device = encoder.described.back().second;
    for (const Channel channel : device.channels) {
        const auto recorded = reader.channel(device, channel);
        if (!recorded)
            return tl::unexpected(recorded.error());
        const auto span = recorded->span();
        if (!span)
            continue;
        encoder.channels.push_back(channel);
        encoder.span = {std::min(encoder.span.from, span->from), std::max(encoder.span.to, span->to)};
    }
    std::ranges::sort(encoder.channels);
    return encoder.channels.empty() ? std::nullopt : std::optional(std::move(encoder));
}

QString channelNames(const RecordingFacts::Encoder &encoder)
{
    return listed(encoder.channels, [](Channel channel) { return QString(channelKey(channel)); });
}

QString busNameOf(const RecordingFacts &facts, BusId bus)
{
    const auto found = std::ranges::find(facts.buses, bus, &RecordedBus::bus);
    return found == facts.buses.end() ? QString() : found->name;
}

QString line(const QString &pattern, const QStringList &parts)
{
    return sentence(pattern, parts) + u'\n';
}

QString stateLine(const RecordingFacts &facts)
{
    const QString until = recordedTimeText(facts.clock, facts.head.until);
    return facts.head.hasEnded
               ? line(CommandLine::tr("It ended at %1."), {until})
               : line(CommandLine::tr("It has not ended: it is still being written, or its program was "
                                      "killed. What came until %1 is there."),
                      {until});
}

QString encoderTable(const RecordingFacts &facts)
{
    TextTable table;
    table.add({CommandLine::tr("place"), CommandLine::tr("values"), CommandLine::tr("from"),
               CommandLine::tr("to"), CommandLine::tr("device")});
    for (const RecordingFacts::Encoder &encoder : facts.encoders)
        table.add({encoder.place.key(), channelNames(encoder),
                   recordedTimeText(facts.clock, encoder.span.from),
                   recordedTimeText(facts.clock, encoder.span.to), encoder.device.name});
    return table.toString();
}

QJsonObject encoderJson(const RecordingFacts &facts, const RecordingFacts::Encoder &encoder)
{
    QJsonArray channels;
    for (const Channel channel : encoder.channels)
        channels.append(QString(channelKey(channel)));
    return {{QStringLiteral("bus"), encoder.place.bus.number},
            {QStringLiteral("busName"), textJson(busNameOf(facts, encoder.place.bus))},
            {QStringLiteral("place"), encoder.place.toString()},
            {QStringLiteral("key"), encoder.place.key()},
            {QStringLiteral("device"), textJson(encoder.device.key)},
            {QStringLiteral("deviceName"), textJson(encoder.device.name)},
            {QStringLiteral("channels"), channels},
            {QStringLiteral("from"), timeJson(encoder.span.from)},
            {QStringLiteral("to"), timeJson(encoder.span.to)}};
}

QString countsLine(const RecordingFacts &facts)
{
    QString text = line(CommandLine::tr("Messages: %1. Notes: %2. Lost values: %3."),
                        {QString::number(facts.counts.messages), QString::number(facts.counts.notes),
                         QString::number(facts.counts.lost)});
    const std::size_t set = facts.clock.changes().size();
    if (set > 1)
        text += line(CommandLine::tr(
                         "The clock of the computer was set meanwhile, times: %1. The times of the samples "
                         "pass evenly all the same."),
                     {QString::number(set - 1)});
    if (facts.head.since > facts.head.begun)
        text += line(CommandLine::tr("It is limited: what was before %1 is not there any more."),
                     {recordedTimeText(facts.clock, facts.head.since)});
    return text;
}

} // namespace

QString recordedTimeText(const WallClock &clock, Instant at)
{
    const QDateTime there = dateTimeOf(clock.wall(at));
    return there.toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss.zzz")) + offsetIfTwice(there);
}

Result<RecordingFacts> RecordingFacts::of(const RecordingReader &reader)
{
    auto head = reader.head();
    auto clock = reader.clock();
    auto buses = reader.buses();
    auto devices = reader.devices();
    auto counts = reader.counts();
    if (!head || !clock || !buses)
        return tl::unexpected(!head ? head.error() : !clock ? clock.error() : buses.error());
    if (!devices || !counts)
        return tl::unexpected(!devices ? devices.error() : counts.error());
    RecordingFacts facts{.file = reader.file(),
                         .bytes = ServerAddress::isMeant(reader.file())
                                      ? std::nullopt
                                      : std::optional(QFileInfo(reader.file()).size()),
                         .head = *head,
                         .clock = *clock,
                         .buses = *buses,
                         .encoders = {},
                         .counts = *counts,
                         .span = {}};
    for (const RecordingReader::Device &device : *devices) {
        auto encoder = encoderOf(reader, device);
        if (!encoder)
            return tl::unexpected(encoder.error());
        if (!*encoder)
            continue;
        const TimeSpan its = (*encoder)->span;
        facts.span = facts.span
                         ? TimeSpan{std::min(facts.span->from, its.from), std::max(facts.span->to, its.to)}
                         : its;
        facts.encoders.push_back(**std::move(encoder));
    }
    std::ranges::sort(facts.encoders, {}, &Encoder::place);
    return facts;
}

// Of a server it is not known.
QString RecordingFacts::text() const
{
    const QString size = bytes ? QLocale().formattedDataSize(*bytes, 1, QLocale::DataSizeSIFormat)
                               : CommandLine::tr("on a server");
    if (!span)
        return line(CommandLine::tr("%1: %2. No encoder has shown anything."), {file, size}) +
               stateLine(*this);
    return line(
               CommandLine::tr("%1: %2, %3 from %4 to %5."),
               {file, size,
                roughDurationText(std::chrono::round<std::chrono::seconds>(span->to - span->from), QLocale()),
                recordedTimeText(clock, span->from), recordedTimeText(clock, span->to)}) +
           stateLine(*this) + u'\n' + encoderTable(*this) + u'\n' + countsLine(*this);
}

QJsonObject RecordingFacts::json() const
{
    QJsonArray all;
    for (const Encoder &encoder : encoders)
        all.append(encoderJson(*this, encoder));
    return {{QStringLiteral("file"), file},
            {QStringLiteral("bytes"), bytes ? QJsonValue(*bytes) : QJsonValue()},
            {QStringLiteral("program"), head.program},
            {QStringLiteral("timeZone"), head.zone},
            {QStringLiteral("begun"), timeJson(head.begun)},
            {QStringLiteral("from"), span ? timeJson(span->from) : QJsonValue()},
            {QStringLiteral("to"), span ? timeJson(span->to) : QJsonValue()},
            {QStringLiteral("until"), timeJson(head.until)},
            {QStringLiteral("ended"), head.hasEnded},
            {QStringLiteral("encoders"), all},
            {QStringLiteral("messages"), counts.messages},
            {QStringLiteral("notes"), counts.notes},
            {QStringLiteral("lost"), static_cast<qint64>(counts.lost)},
            {QStringLiteral("traffic"), counts.hasTraffic},
            {QStringLiteral("clockSet"),
             static_cast<qint64>(std::max<std::size_t>(clock.changes().size(), 1)) - 1}};
}

} // namespace codewheel
