// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_reader.h"

#include "history/track.h"
#include "recording/postgres_database.h"
#include "recording/recording_tables.h"

#include <QFileInfo>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

namespace codewheel {
namespace {

Instant timeOf(const QSqlQuery &row, int column)
{
    return recordedTime(row.value(column).toLongLong());
}

std::optional<TrafficKind> kindOf(const QString &key)
{
    const auto found =
        std::ranges::find_if(trafficKindKeys, [&](const char *one) { return key == QLatin1String(one); });
    return found == trafficKindKeys.end()
               ? std::nullopt
               : std::optional(static_cast<TrafficKind>(found - trafficKindKeys.begin()));
}

RecordingHead headOf(const QSqlQuery &row)
{
    return {.program = row.value(0).toString(),
            .zone = row.value(1).toString(),
            .begun = timeOf(row, 2),
            .since = timeOf(row, 3),
            .until = timeOf(row, 4),
            .hasEnded = !row.value(5).isNull()};
}

RecordedBus busOf(const QSqlQuery &row)
{
    return {BusId{row.value(0).toInt()}, row.value(1).toString()};
}

RecordingReader::Description descriptionOf(const QSqlQuery &row)
{
    return {timeOf(row, 0), row.value(1).toString().toUtf8()};
}

RecordingReader::StoredAt storedAt(const QSqlQuery &row)
{
    const int severity = std::clamp(row.value(2).toInt(), 0, static_cast<int>(Severity::fault));
    return {timeOf(row, 0),
            {.id = row.value(1).toLongLong(),
             .at = std::chrono::duration_cast<std::chrono::milliseconds>(timeOf(row, 0)).count(),
             .severity = static_cast<Severity>(severity),
             .place = Place::ofKey(row.value(3).toString()),
             .code = row.value(4).toString(),
             .arguments = row.value(5).toString(),
             .refusal = row.value(6).toString()}};
}

RecordedNote noteOf(const QSqlQuery &row)
{
    return {timeOf(row, 0), row.value(1).toString()};
}

RecordedTraffic trafficOf(const QSqlQuery &row)
{
    RecordedTraffic entry{timeOf(row, 0), BusId{row.value(1).toInt()}, {}};
    entry.row.at = entry.at;
    entry.row.time = QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<std::chrono::milliseconds>(entry.at).count());
    entry.row.place = Place::ofKey(row.value(2).toString());
    entry.row.kind = kindOf(row.value(3).toString());
    entry.row.cycle = static_cast<std::uint64_t>(row.value(4).toLongLong());
    entry.row.out = static_cast<Word>(row.value(5).toLongLong());
    entry.row.in = static_cast<Word>(row.value(6).toLongLong());
    entry.row.bytes = row.value(7).toByteArray();
    entry.row.isAutomatic = row.value(8).toInt() != 0;
    entry.row.isTyped = row.value(9).toInt() != 0;
    return entry;
}

RecordedLoss lossOf(const QSqlQuery &row)
{
    return {timeOf(row, 0), BusId{row.value(1).toInt()},
            static_cast<std::uint64_t>(row.value(2).toLongLong())};
}

RecordedClock clockOf(const QSqlQuery &row)
{
    return {timeOf(row, 0), timeOf(row, 1)};
}

RecordingReader::Counts countsOf(const QSqlQuery &row)
{
    return {.messages = row.value(0).toLongLong(),
            .notes = row.value(1).toLongLong(),
            .lost = static_cast<std::uint64_t>(std::max(row.value(2).toLongLong(), 0LL)),
            .hasTraffic = row.value(3).toInt() != 0};
}

struct DeviceAndChannel
{
    qint64 device;
    QString place;
    QString channel;
};

DeviceAndChannel deviceOf(const QSqlQuery &row)
{
    return {row.value(0).toLongLong(), row.value(1).toString(), row.value(2).toString()};
}

struct ChannelLimits
{
    qint64 id;
    Instant until;
    std::optional<Instant> gapSince;
};

std::optional<Instant> beginOf(const QSqlQuery &row)
{
    return row.value(0).isNull() ? std::nullopt : std::optional(timeOf(row, 0));
}

ChannelLimits limitsOf(const QSqlQuery &row)
{
    return {row.value(0).toLongLong(), timeOf(row, 1),
            row.value(2).isNull() ? std::nullopt : std::optional(timeOf(row, 2))};
}

} // namespace

Result<RecordingReader> RecordingReader::open(const QString &file)
{
    if (ServerAddress::isMeant(file))
        return ServerAddress::parse(file).and_then(openOnServer);
    auto database = Database::openToRead(file, recordingSchema());
    if (!database)
        return refuse(RefusalKind::link, RefusalId::databaseFailed, {file, database.error().reason});
    return RecordingReader(file, std::make_shared<Database>(std::move(*database)));
}

Result<RecordingReader> RecordingReader::openOnServer(ServerAddress address)
{
    auto database = PostgresDatabase::connectToRead(address);
    if (!database)
        return refuse(RefusalKind::link, RefusalId::databaseFailed,
                      {address.place(), database.error().reason});
    return RecordingReader(address.text(), std::move(*database));
}

template <class Row>
Result<std::vector<Row>> RecordingReader::rows(const QString &statement, const std::vector<QVariant> &values,
                                               Row (*rowOf)(const QSqlQuery &)) const
{
    QSqlQuery query = m_database->query(statement);
    for (int i = 0; i < static_cast<int>(values.size()); ++i)
        query.bindValue(i, values[static_cast<std::size_t>(i)]);
    auto done = m_database->run(query);
    std::vector<Row> all;
    while (done && query.next())
        all.push_back(rowOf(query));
    if (done && query.lastError().isValid()) // in the middle of the file
        done = tl::unexpected(m_database->reasonOf(query.lastError()));
    if (!done)
        return refuse(RefusalKind::link, RefusalId::databaseFailed, {m_file, done.error().reason});
    return all;
}

Result<RecordingHead> RecordingReader::head() const
{
    const auto heads =
        rows(QStringLiteral("SELECT program, zone, begun, since, until, ended FROM recording"), {}, headOf);
    if (!heads)
        return tl::unexpected(heads.error());
    if (heads->size() != 1)
        return refuse(RefusalKind::link, RefusalId::databaseFailed, {m_file, Database::damaged().reason});
    return heads->front();
}

// The order of blocks is by channel.
Result<std::optional<TimeSpan>> RecordingReader::span() const
{
    const auto about = head();
    const auto begun =
        rows(QStringLiteral("SELECT min(start) FROM (SELECT (SELECT min(start) FROM block WHERE "
                            "channel = channel.id) AS start FROM channel) AS begins"),
             {}, beginOf);
    if (!about || !begun)
        return tl::unexpected(about ? begun.error() : about.error());
    if (begun->empty() || !begun->front())
        return std::nullopt;
    const Instant from = std::max(*begun->front(), about->since);
    return TimeSpan{from, std::max(from, about->until) + Instant(1)};
}

Result<std::vector<RecordedBus>> RecordingReader::buses() const
{
    return rows(QStringLiteral("SELECT number, name FROM bus ORDER BY number"), {}, busOf);
}

Result<std::vector<RecordingReader::Device>> RecordingReader::devices() const
{
    const auto found =
        rows(QStringLiteral("SELECT device.id, device.place, channel.kind FROM device LEFT JOIN channel "
                            "ON channel.device = device.id ORDER BY device.id, channel.id"),
             {}, deviceOf);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<Device> devices;
    for (const DeviceAndChannel &row : *found) {
        const auto place = Place::ofKey(row.place);
        if (!place)
            continue;
        if (devices.empty() || devices.back().id != row.device)
            devices.push_back({row.device, *place});
        if (const auto channel = channelFromKey(row.channel))
            devices.back().channels.push_back(*channel);
    }
    return devices;
}

Result<std::vector<RecordingReader::Description>> RecordingReader::descriptions(const Device &device) const
{
    return rows(QStringLiteral("SELECT since, json FROM description WHERE device = ? ORDER BY since"),
                {device.id}, descriptionOf);
}

Result<std::vector<RecordingReader::StoredAt>> RecordingReader::messages(const TimeSpan &span, int most) const
{
    return rows(QStringLiteral("SELECT at, id, severity, place, code, arguments, refusal FROM message "
                               "WHERE at >= ? AND at < ? ORDER BY at, id LIMIT ?"),
                {qint64{span.from.count()}, qint64{span.to.count()}, most}, storedAt);
}

Result<std::vector<RecordedNote>> RecordingReader::notes(const TimeSpan &span, int most) const
{
    return rows(QStringLiteral("SELECT at, text FROM note WHERE at >= ? AND at < ? ORDER BY at LIMIT ?"),
                {qint64{span.from.count()}, qint64{span.to.count()}, most}, noteOf);
}

Result<std::vector<RecordedTraffic>> RecordingReader::traffic(const TimeSpan &span, int most) const
{
    return rows(
        QStringLiteral("SELECT at, bus, place, kind, cycle, word_out, word_in, bytes, automatic, typed "
                       "FROM traffic WHERE at >= ? AND at < ? ORDER BY at, id LIMIT ?"),
        {qint64{span.from.count()}, qint64{span.to.count()}, most}, trafficOf);
}

Result<std::vector<RecordedLoss>> RecordingReader::losses() const
{
    return rows(QStringLiteral("SELECT at, bus, amount FROM loss ORDER BY at, id"), {}, lossOf);
}

Result<RecordingReader::Counts> RecordingReader::counts() const
{
    return rows(QStringLiteral("SELECT (SELECT COUNT(*) FROM message), (SELECT COUNT(*) FROM note), "
                               "(SELECT SUM(amount) FROM loss), "
                               "CASE WHEN EXISTS (SELECT 1 FROM traffic) THEN 1 ELSE 0 END"),
                {}, countsOf)
        .map([](const std::vector<Counts> &counts) { return counts.front(); });
}

Result<WallClock> RecordingReader::clock() const
{
    return rows(QStringLiteral("SELECT at, wall FROM clock ORDER BY at"), {}, clockOf)
        .map([](std::vector<RecordedClock> clocks) { return WallClock(std::move(clocks)); });
}

Result<RecordedChannel> RecordingReader::channel(const Device &device, Channel channel) const
{
    const auto found = rows(QStringLiteral("SELECT channel.id, device.until, channel.gap_since FROM channel "
                                           "JOIN device ON device.id = channel.device "
                                           "WHERE channel.device = ? AND channel.kind = ?"),
                            {device.id, channelKey(channel)}, limitsOf);
    const auto about = head();
    if (!found || !about)
        return tl::unexpected(found ? about.error() : found.error());
    if (found->empty())
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {device.place.key(), QString()});
    const ChannelLimits &limits = found->front();
    RecordedChannel made(*m_database, m_file, limits.id, {about->since, limits.until, limits.gapSince});
    if (auto ends = made.findEnds(); !ends)
        return made.refusal(ends.error());
    return made;
}

} // namespace codewheel
