// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recorded_channel.h"
#include "recording/recording_clock.h"
#include "recording/recording_store.h"
#include "recording/server_address.h"

namespace codewheel {

// A recording to look at, in a file or on a server: also one that is still being written, or whose program
// was killed. Reads only what is asked for. Used by the thread that opened it.
class RecordingReader
{
public:
    struct Device
    {
        qint64 id = 0;
        Place place{};
        std::vector<Channel> channels{};
    };
    struct Description
    {
        Instant since{};
        QByteArray json;
    };
    struct StoredAt
    {
        Instant at{};
        StoredMessage message;
    };

    struct Counts
    {
        qint64 messages = 0;
        qint64 notes = 0;
        std::uint64_t lost = 0; // values
        bool hasTraffic = false;
    };

    // A file, or the address of a server (ServerAddress).
    static Result<RecordingReader> open(const QString &file);

    const QString &file() const { return m_file; }
    Result<RecordingHead> head() const; // as it is now
    // From the first sample of all to just behind what is in the file; nothing: there is none.
    Result<std::optional<TimeSpan>> span() const;
    Result<std::vector<RecordedBus>> buses() const;
    Result<std::vector<Device>> devices() const;
    Result<std::vector<Description>> descriptions(const Device &device) const; // oldest first
    // Those of a span, oldest first; at most `most`.
    Result<std::vector<StoredAt>> messages(const TimeSpan &span, int most) const;
    Result<std::vector<RecordedNote>> notes(const TimeSpan &span, int most) const;
    Result<std::vector<RecordedTraffic>> traffic(const TimeSpan &span, int most) const;
    Result<std::vector<RecordedLoss>> losses() const;
    Result<Counts> counts() const;
    Result<WallClock> clock() const;
    // Refused if the device has none of these.
    Result<RecordedChannel> channel(const Device &device, Channel channel) const;

private:
    RecordingReader(QString file, std::shared_ptr<const SqlConnection> database)
        : m_file(std::move(file))
        , m_database(std::move(database))
    {}
    static Result<RecordingReader> openOnServer(ServerAddress address);
    template <class Row>
    Result<std::vector<Row>> rows(const QString &statement, const std::vector<QVariant> &values,
                                  Row (*rowOf)(const QSqlQuery &)) const;

    QString m_file;
    std::shared_ptr<const SqlConnection> m_database; // channels refer to it
};

} // namespace codewheel
