// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/encoder_history.h"
#include "recording/recording_reader.h"
#include "recording/recording_writer.h"
#include "tests/support/places.h"

#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel::test {

using namespace std::chrono_literals;

// 1 March 2026, 12:00 UTC.
constexpr Instant noon = 1'772'366'400s;

// A recording in a folder of its own.
class RecordingFile
{
public:
    QString folder() const { return m_folder.path(); }
    RecordingSettings settings() const
    {
        return {.file = path,
                .program = QStringLiteral("test"),
                .zone = QStringLiteral("UTC"),
                .begun = noon,
                .leastFree = 0};
    }
    std::unique_ptr<RecordingWriter> begin() const { return begin(settings()); }
    static std::unique_ptr<RecordingWriter> begin(const RecordingSettings &settings)
    {
        auto writer = RecordingWriter::begin(settings);
        EXPECT_TRUE(writer);
        return writer ? std::move(*writer) : nullptr;
    }
    RecordingReader reader() const
    {
        auto reader = RecordingReader::open(path);
        EXPECT_TRUE(reader);
        return std::move(reader.value());
    }
    static RecordedChannel channel(const RecordingReader &reader, Channel channel, std::size_t device = 0)
    {
        const auto devices = reader.devices();
        EXPECT_TRUE(devices);
        auto found = reader.channel(devices->at(device), channel);
        EXPECT_TRUE(found);
        return std::move(found.value());
    }
    QByteArray bytes() const
    {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }
    void fill(const QByteArray &bytes) const
    {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        EXPECT_EQ(file.write(bytes), bytes.size());
    }
    // As another program would.
    QVariant execute(const QString &sql) const
    {
        QVariant result;
        {
            auto connection = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), path);
            connection.setDatabaseName(path);
            EXPECT_TRUE(connection.open());
            QSqlQuery query(connection);
            EXPECT_TRUE(query.exec(sql)) << sql.toStdString();
            if (query.next())
                result = query.value(0);
        }
        QSqlDatabase::removeDatabase(path);
        return result;
    }

private:
    QTemporaryDir m_folder;

public:
    const QString path = m_folder.filePath(QStringLiteral("night.cwrec"));
};

// Positions, one each millisecond from then on.
inline RecordedValues positions(Instant from, std::size_t count, auto value, Place place = "1.0"_ring)
{
    RecordedValues values{place, {}};
    for (std::size_t index = 0; index < count; ++index)
        values.values.push_back(
            {.at = from + 1ms * index, .position = static_cast<std::int64_t>(value(index))});
    return values;
}

inline std::vector<Sample> samplesOf(RecordedChannel &channel,
                                     const TimeSpan &span = {Instant(0), Instant::max()})
{
    std::vector<Sample> samples;
    EXPECT_TRUE(channel.forEach(span, [&](const Sample &sample, const std::optional<Instant> &) {
        samples.push_back(sample);
        return true;
    }));
    return samples;
}

} // namespace codewheel::test
