// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/postgres_database.h"
#include "recording/recording_tables.h"
#include "recording/server_recording.h"
#include "tests/recording/postgres_server.h"
#include "tests/recording/recording_file.h"
#include "vocabulary/refusal_text.h"

#include <QDir>
#include <QDirIterator>

#include <gmock/gmock.h>

namespace codewheel::test {

inline constexpr auto noServer = "Debian's PostgreSQL server (package postgresql) or Qt's driver for it "
                                 "(libqt6sql6-psql) is not installed";

// A recording on a server in a database of its own, which waits in a folder of its own.
class ServerRecordings : public testing::Test
{
protected:
    void SetUp() override
    {
        if (server == nullptr)
            GTEST_SKIP() << noServer;
        server->setPassword(QString::fromLatin1(PostgresServer::password));
        address = server->newDatabase();
    }
    RecordingSettings settings() const { return settings(address); }
    RecordingSettings settings(const QString &to) const
    {
        RecordingSettings settings = file.settings();
        settings.file.clear();
        settings.server = to;
        settings.unsentFolder = file.folder();
        return settings;
    }
    static std::unique_ptr<RecordingTarget> begin(const RecordingSettings &settings)
    {
        auto begun = RecordingTarget::begin(settings);
        EXPECT_TRUE(begun) << (begun ? "" : refusalText(begun.error()).toStdString());
        return begun ? std::move(*begun) : nullptr;
    }
    Refusal refused(const QString &to) const
    {
        const auto begun = RecordingTarget::begin(settings(to));
        EXPECT_FALSE(begun);
        EXPECT_THAT(waitingFiles(), testing::IsEmpty());
        return begun ? Refusal() : begun.error();
    }
    static RecordingReader reader(const QString &recording)
    {
        auto reader = RecordingReader::open(recording);
        EXPECT_TRUE(reader) << (reader ? "" : refusalText(reader.error()).toStdString());
        return std::move(reader.value());
    }
    QStringList waitingFiles() const
    {
        QStringList found;
        QDirIterator all(file.folder(), {QStringLiteral("codewheel_*.cwrec")}, QDir::Files,
                         QDirIterator::Subdirectories);
        while (all.hasNext())
            found << all.next();
        return found;
    }
    QString database() const { return address.section(u'/', -1); }

    const RecordingFile file{};
    PostgresServer *server = PostgresServer::shared();
    QString address;
};

} // namespace codewheel::test
