// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorded_device.h"
#include "recording/recording_writer.h"
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QScopeGuard>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr Instant noon = 1'772'366'400s; // 1 March 2026, 12:00 UTC

class CliExport : public testing::Test
{
protected:
    CliRun tell() const { return runLine(QStringLiteral("export %1 --json").arg(file)); }
    CliRun save(const QString &options = {}) const
    {
        return runLine(QStringLiteral("export %1 -o %2 --json ").arg(file, table) + options);
    }
    void record(const QString &options) const
    {
        const CliRun run = runLine(QStringLiteral("record -o %1 ").arg(file) + options);
        ASSERT_EQ(run.exit, 0) << run.err;
    }
    // Positions 0, 1, 2 ... each second, as of an encoder without a description.
    std::unique_ptr<RecordingWriter> writer() const
    {
        auto begun = RecordingWriter::begin({.file = file, .program = QStringLiteral("test"), .begun = noon});
        EXPECT_TRUE(begun);
        return std::move(*begun);
    }
    static void addSeconds(RecordingWriter &recording, int from, int to)
    {
        for (int i = from; i < to; ++i)
            recording.add(RecordedValues{"1.0"_ring, {{.at = noon + i * 1s, .position = i}}});
    }
    // A recording does not say how it was known.
    static QJsonValue valueJson(const QString &parameter, int value, const QString &at)
    {
        return QJsonObject{{QStringLiteral("parameter"), parameter},
                           {QStringLiteral("value"), value},
                           {QStringLiteral("evidence"), QJsonValue()},
                           {QStringLiteral("at"), at}};
    }
    QByteArray contents(const QString &path) const
    {
        QFile its(path);
        EXPECT_TRUE(its.open(QIODevice::ReadOnly));
        return its.readAll();
    }
    QList<QByteArray> lines() const { return contents(table).trimmed().split('\n'); }

    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("shaft.cwrec"));
    QString table = folder.filePath(QStringLiteral("shaft.csv"));
    QString description = folder.filePath(QStringLiteral("shaft.json"));
};

TEST_F(CliExport, WithoutATableItTellsWhatIsInTheRecording)
{
    record(QStringLiteral("4.0 05 --for 2"));
    const QJsonObject json = tell().json();
    EXPECT_EQ(json[u"encoders"].toArray().size(), 2);
    EXPECT_TRUE(json[u"ended"].toBool());
    EXPECT_EQ(json[u"bytes"].toInteger(), QFileInfo(file).size());
    const CliRun run = runLine(QStringLiteral("export ") + file);
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("It ended at 2"));
    EXPECT_THAT(run.out, HasSubstr("esc:05  position, speed "));
    EXPECT_FALSE(QFileInfo::exists(table));
}

TEST_F(CliExport, OneThatIsStillWrittenOrWasKilledIsToldAsSuch)
{
    const auto recording = writer();
    addSeconds(*recording, 0, 10);
    recording->flush();
    EXPECT_FALSE(tell().json()[u"ended"].toBool());
    EXPECT_THAT(runLine(QStringLiteral("export ") + file).out, HasSubstr("It has not ended: "));
    EXPECT_EQ(save().json()[u"rows"].toInt(), 10);
}

TEST_F(CliExport, AllValuesWithADescriptionBesideThem)
{
    record(QStringLiteral("4.0 --for 2"));
    const CliRun run = save();
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(lines().front().trimmed(), "time [s],4.0 position [steps],4.0 speed [steps/s],4.0 IN,4.0 OUT");
    EXPECT_EQ(lines().size(), run.json()[u"rows"].toInt() + 1);
    const QJsonObject json = QJsonDocument::fromJson(contents(description)).object();
    EXPECT_EQ(json[u"rows"], run.json()[u"rows"]);
    const QJsonValue encoder = json[u"encoders"].toArray()[0];
    EXPECT_EQ(encoder[u"deviceName"], QStringLiteral("FRABA OCD-IB K2"));
    EXPECT_EQ(encoder[u"stepsPerTurn"].toInt(), 4'096);
}

TEST_F(CliExport, ChosenTracksInAUnitForAPartOfTheTime)
{
    record(QStringLiteral("4.0 3.0 --for 10"));
    const CliRun run =
        save(QStringLiteral("--tracks 4.0/position,3.0/in.2 --unit degrees --from +2 --to=-7"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(lines().front().trimmed(), "time [s],4.0 position [deg],3.0 IN.2");
    const double first = lines()[1].split(',').front().toDouble();
    const double last = lines().back().split(',').front().toDouble();
    EXPECT_NEAR(last - first, 1, 0.01);
    const CliRun again =
        save(QStringLiteral("--yes --tracks 4.0/position --unit millimetres --mm-per-turn 10 "
                            "--to +0.01"));
    EXPECT_EQ(again.exit, 0) << again.err;
    EXPECT_EQ(lines().front().trimmed(), "time [s],4.0 position [mm]");
}

TEST_F(CliExport, WhatWasRecordedBeforeTheScaleChangedKeepsItsScale)
{
    const auto recording = writer();
    const auto describe = [&](Instant at, std::int64_t steps) {
        const RecordedDevice device{.key = QStringLiteral("fraba-ocd-ib"),
                                    .known = {{Parameter::steps, steps}, {Parameter::revolutions, 1}}};
        recording->add(RecordedDescription{"1.0"_ring, at, toJson(device)});
    };
    describe(noon, 360);
    addSeconds(*recording, 0, 5);
    describe(noon + 5s, 720);
    addSeconds(*recording, 5, 10);
    recording->flush();
    const CliRun run = save(QStringLiteral("--tracks 1.0/position --unit degrees"));
    EXPECT_EQ(run.exit, 0) << run.err;
    ASSERT_EQ(lines().size(), 11);
    EXPECT_EQ(lines()[5].trimmed().split(',')[1].toDouble(), 4);
    EXPECT_EQ(lines()[6].trimmed().split(',')[1].toDouble(), 2.5);
    const QJsonObject json = QJsonDocument::fromJson(contents(description)).object();
    const QJsonObject column = json[u"columns"].toArray().at(0).toObject();
    EXPECT_EQ(column[u"perStep"].toDouble(), 0.5);
    EXPECT_EQ(column[u"earlierScales"].toArray().size(), 1);
    const QJsonArray values = json[u"encoders"].toArray().at(0)[u"values"].toArray();
    EXPECT_THAT(values,
                testing::UnorderedElementsAre(
                    valueJson(QStringLiteral("steps"), 720, QStringLiteral("2026-03-01T12:00:05.000Z")),
                    valueJson(QStringLiteral("revolutions"), 1, QStringLiteral("2026-03-01T12:00:00.000Z"))));
}

TEST_F(CliExport, NothingIsReplacedUnlessAsked)
{
    record(QStringLiteral("4.0 --for 1"));
    EXPECT_EQ(save().exit, 0);
    const QByteArray before = contents(table);
    EXPECT_EQ(errorKey(save(QStringLiteral("--to +0.5"))), "fileExists");
    EXPECT_EQ(contents(table), before);
    ASSERT_TRUE(QFile::remove(table));
    EXPECT_EQ(errorKey(save()), "fileExists") << "the description";
    EXPECT_EQ(save(QStringLiteral("--yes --to +0.5")).exit, 0);
    EXPECT_LT(contents(table).size(), before.size());
    EXPECT_EQ(errorKey(runLine(QStringLiteral("export %1 -o %1 --yes --json").arg(file))), "fileExists");
    EXPECT_TRUE(tell().json()[u"ended"].toBool()) << "the recording itself";
}

// 25 October 2026 in Berlin: 3:00 is 2:00 once more.
TEST_F(CliExport, AnHourThatComesTwiceIsExportedFromItsFirstToItsLast)
{
    const QByteArray zone = qgetenv("TZ");
    qputenv("TZ", "Europe/Berlin");
    const auto restore = qScopeGuard([&] { zone.isNull() ? qunsetenv("TZ") : qputenv("TZ", zone); });
    const Instant halfPastTwo =
        std::chrono::milliseconds(QDateTime(QDate(2026, 10, 25), QTime(0, 30), Qt::UTC).toMSecsSinceEpoch());
    auto recording = writer();
    for (const int minutes : {-60, 0, 60, 120})
        recording->add(
            RecordedValues{"1.0"_ring, {{.at = halfPastTwo + minutes * 1min, .position = minutes}}});
    recording->end();
    const QString from = QStringLiteral("--yes --dates --from 2026-10-25T02:30");
    ASSERT_EQ(save(from + QStringLiteral(" --to 2026-10-25T02:30")).exit, 0);
    EXPECT_THAT(contents(table).toStdString(), HasSubstr(",2026-10-25T02:30:00.000000+02:00,0\r\n"));
    EXPECT_THAT(contents(table).toStdString(), HasSubstr(",2026-10-25T02:30:00.000000+01:00,60\r\n"));
    ASSERT_EQ(save(from + QStringLiteral("+01:00")).exit, 0);
    EXPECT_THAT(contents(table).toStdString(), testing::Not(HasSubstr("+02:00")));
    EXPECT_THAT(runLine(QStringLiteral("export %1 --yes -o %2 --from 2026-10-25T02:30").arg(file, table)).out,
                HasSubstr("from 2026-10-25T02:30:00.000+02:00"));
}

struct BadExport
{
    const char *options;
    const char *key;
};

TEST_F(CliExport, BadInputIsASentenceAndSavesNothing)
{
    record(QStringLiteral("4.0 05 --for 2"));
    for (const auto &[options, key] : {BadExport{"--tracks 9.9/position", "noSuchTrack"},
                                       {"--tracks 05/in", "noSuchTrack"},
                                       {"--tracks 4.0/in.32", "noSuchTrack"},
                                       {"--tracks 4.0/in,,4.0/out", "noSuchTrack"},
                                       {"--from yesterday", "badTime"},
                                       {"--to +much", "badTime"},
                                       {"--from +5", "nothingThen"},
                                       {"--from 2001-01-01 --to 2001-01-02", "nothingThen"},
                                       {"--from +1 --to +1", "nothingThen"},
                                       {"--locale --dates", "badOption"},
                                       {"--unit furlongs", "optionNotAllowed"},
                                       {"--unit millimetres", "unitNotKnown"},
                                       {"--mm-per-turn 0", "notANumber"}}) {
        const CliRun run = save(QString::fromLatin1(options));
        EXPECT_EQ(errorKey(run), key) << options;
        EXPECT_EQ(run.exit, 2) << options;
        EXPECT_FALSE(QFileInfo::exists(table) || QFileInfo::exists(description)) << options;
    }
    for (const QString &other :
         {folder.filePath(QStringLiteral("none.cwrec")), QStringLiteral(CODEWHEEL_ROOT "/README.md")})
        EXPECT_EQ(errorKey(runLine(QStringLiteral("export %1 --json").arg(other))), "databaseFailed");
}

// At 12:00:50 of its clock it became 11:00:50: an hour of the day comes twice.
TEST_F(CliExport, AfterTheClockWasSetBackAnHourIsExportedTwice)
{
    const auto recording = writer();
    recording->add(RecordedClock{noon, noon});
    addSeconds(*recording, 0, 50);
    recording->add(RecordedClock{noon + 50s, noon + 50s - 1h});
    recording->add(RecordedClock{noon + 51s, noon + 51s - 1h});
    addSeconds(*recording, 50, 8'000);
    recording->end();
    EXPECT_EQ(tell().json()[u"clockSet"].toInt(), 1);
    const auto local = [](Instant at) {
        return QDateTime::fromSecsSinceEpoch(std::chrono::floor<std::chrono::seconds>(at).count())
            .toString(Qt::ISODate);
    };
    const CliRun run = save(QStringLiteral("--from %1 --to %2").arg(local(noon + 10s), local(noon + 20s)));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.json()[u"rows"].toInt(), 3'611) << "10 s of the first hour, up to 20 s of the second";
}

TEST_F(CliExport, PandasReadsItAsItIs)
{
    record(QStringLiteral("4.0 --for 2"));
    ASSERT_EQ(save().exit, 0);
    QProcess python;
    python.start(QStringLiteral(DEBIAN_PYTHON3),
                 {QStringLiteral("-c"),
                  QStringLiteral("import sys, pandas as p\n"
                                 "t = p.read_csv(sys.argv[1])\n"
                                 "print(len(t), t['4.0 position [steps]'].iloc[0])\n"),
                  table});
    ASSERT_TRUE(python.waitForFinished(60'000));
    const QByteArray error = python.readAllStandardError();
    if (error.contains("No module named"))
        GTEST_SKIP() << "the package python3-pandas is not installed";
    EXPECT_EQ(python.readAllStandardOutput().trimmed(),
              QByteArray::number(lines().size() - 1) + " " + lines()[1].split(',')[1])
        << error.toStdString();
}

} // namespace
} // namespace codewheel
