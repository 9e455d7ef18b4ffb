// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_reader.h"
#include "tests/cli/cli_run.h"
#include "tests/cli/kinds/esc/shared_line.h"
#include "tests/support/no_room.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

class CliRecord : public testing::Test
{
protected:
    CliRun record(const QString &line, const Person &person = {}) const
    {
        return runLine(QStringLiteral("record -o %1 ").arg(file) + line, person);
    }
    RecordingReader reader() const
    {
        auto reader = RecordingReader::open(file);
        EXPECT_TRUE(reader);
        return std::move(*reader);
    }
    std::vector<Sample> samples(const QString &place, Channel channel) const
    {
        std::vector<Sample> all;
        const RecordingReader opened = reader();
        const auto devices = opened.devices().value();
        for (const auto &device : devices)
            if (device.place.key() == place) {
                auto found = opened.channel(device, channel);
                EXPECT_TRUE(found);
                EXPECT_TRUE(
                    found->forEach({Instant(0), Instant::max()}, [&](const Sample &sample, const auto &) {
                        all.push_back(sample);
                        return true;
                    }));
            }
        return all;
    }
    static std::vector<std::string> placesIn(const QJsonObject &json)
    {
        std::vector<std::string> places;
        for (const QJsonValue encoder : json[u"encoders"].toArray())
            places.push_back(encoder[u"place"].toString().toStdString());
        return places;
    }
    static double secondsIn(const QJsonObject &json)
    {
        const auto time = [&](const char *key) {
            return QDateTime::fromString(json.value(QLatin1String(key)).toString(), Qt::ISODateWithMs);
        };
        return static_cast<double>(time("from").msecsTo(time("to"))) / 1'000;
    }
    // Until the file is that large: something was written after it was made.
    void waitForMore(QProcess &program, qint64 bytes) const
    {
        while (program.state() == QProcess::Running && QFileInfo(file).size() < bytes)
            program.waitForReadyRead(20);
        EXPECT_EQ(program.state(), QProcess::Running) << program.readAllStandardError().toStdString();
    }

    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("shaft.cwrec"));
};

TEST_F(CliRecord, EveryCycleOfAllEncodersOfTheRingAtOnce)
{
    const CliRun run = record(QStringLiteral("--link interbus:training --for 3 --json"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(placesIn(run.json()), ElementsAre("1.0", "2.0", "3.0", "4.0", "5.0", "6.1"));
    EXPECT_TRUE(run.json()[u"ended"].toBool());
    EXPECT_EQ(run.json()[u"lost"].toInt(), 0);
    EXPECT_NEAR(secondsIn(run.json()), 3, 0.01);
    EXPECT_GT(samples(QStringLiteral("4.0"), Channel::position).size(), 1'000U);
    EXPECT_TRUE(reader().head()->hasEnded);
}

TEST_F(CliRecord, OnlyTheNamedOnesOfRingAndLine)
{
    const CliRun run = record(QStringLiteral("4.0 05 4.0 --for 2 --no-traffic --json"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(placesIn(run.json()), ElementsAre("4.0", "esc:05"));
    EXPECT_FALSE(run.json()[u"traffic"].toBool());
    const auto ring = samples(QStringLiteral("4.0"), Channel::position);
    const auto line = samples(QStringLiteral("esc:05"), Channel::position);
    ASSERT_FALSE(ring.empty() || line.empty());
    EXPECT_LT(std::chrono::abs(ring.front().at - line.front().at), 100ms) << "of one moment";
}

TEST_F(CliRecord, SaysWhatItRecordsWhereAndWhatIsInIt)
{
    const CliRun run = record(QStringLiteral("4.0 --for 2"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Recording into " + file.toStdString() +
                                   ": 4.0.\nIt takes 2 s. Ctrl+C "
                                   "ends it.\n"));
    EXPECT_THAT(run.out, HasSubstr(", 2 s from 2"));
    EXPECT_THAT(run.out, HasSubstr("4.0    position, speed, in, out  2"));
    EXPECT_THAT(run.out, HasSubstr("Lost values: 0."));
}

TEST_F(CliRecord, WithoutPlaceALineIsLeftOutUnlessAProjectKnowsItsEncoders)
{
    const CliRun run = record(QStringLiteral("--for 1 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.err, HasSubstr("which encoders the bus \"Line\" has: it is left out."));
    QFile::remove(file);
    const CliRun alone = record(QStringLiteral("--for 1 --link esc:training --json"));
    EXPECT_EQ(errorKey(alone), "nothingToRecord");
    const QString project = folder.filePath(QStringLiteral("line.codewheel"));
    ASSERT_EQ(runLine(QStringLiteral("scan --link esc:training --save ") + project).exit, 0);
    const CliRun known = record(QStringLiteral("--for 1 --json --link esc:training --project ") + project);
    EXPECT_EQ(known.exit, 0) << known.err;
    EXPECT_THAT(placesIn(known.json()), testing::Contains("esc:05"));
}

// 24 bits at -6 rpm from 8000000: 409.6 steps a second downwards.
TEST_F(CliRecord, ATriggerWithWhatIsBeforeAndAfter)
{
    const CliRun run =
        record(QStringLiteral("4.0 --trigger 4.0/position<7998000 --before 2 --after 3 --json"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("The trigger has come."));
    EXPECT_NEAR(secondsIn(run.json()), 5, 0.01);
    EXPECT_EQ(run.json()[u"trigger"], QStringLiteral("4.0/position<7998000"));
    EXPECT_TRUE(run.json()[u"hasTriggered"].toBool());
    const auto all = samples(QStringLiteral("4.0"), Channel::position);
    EXPECT_NEAR(static_cast<double>(all.front().value), 7'998'000 + 2 * 409.6, 2);
    EXPECT_NEAR(static_cast<double>(all.back().value), 7'998'000 - 3 * 409.6, 2);
}

TEST_F(CliRecord, ATriggerAtAnEncoderThatIsNotRecorded)
{
    const CliRun run = record(QStringLiteral("1.0 --trigger Ring/4.0/position<7999000 --after 1 --json"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(placesIn(run.json()), ElementsAre("1.0"));
    EXPECT_EQ(run.json()[u"trigger"], QStringLiteral("4.0/position<7999000"));
}

struct BadRecord
{
    const char *line;
    const char *key;
};

TEST_F(CliRecord, BadInputIsASentenceAndLeavesNothingBehind)
{
    for (const auto &[line, key] : {BadRecord{"4.0 --for 0", "optionOutOfRange"},
                                    {"4.0 --for soon", "optionOutOfRange"},
                                    {"4.0 --for 31622401", "optionOutOfRange"},
                                    {"4.0 --trigger fault --before 3601", "optionOutOfRange"},
                                    {"4.0 --last 0", "optionOutOfRange"},
                                    {"4.0 --for 1 --max-size 0", "optionOutOfRange"},
                                    {"4.0 --for 1 --keep-free -1", "optionOutOfRange"},
                                    {"4.0 --before 2", "badOption"},
                                    {"4.0 --for 2 --after 2", "badOption"},
                                    {"4.0 --for 2 --trigger fault", "badOption"},
                                    {"--for 2 --device fraba-ocd-ib", "missingPlace"},
                                    {"9.9 --for 2", "unknownDevice"},
                                    {"6.0 --for 2", "noEncoder"},
                                    {"0C --for 2", "encoderSilent"},
                                    {"4.0 --trigger nonsense", "badTrigger"},
                                    {"4.0 --trigger 4.0/position", "badTrigger"},
                                    {"4.0 --trigger 4.0/position>much", "badTrigger"},
                                    {"4.0 --trigger 4.0/in.32", "badTrigger"},
                                    {"4.0 --trigger 4.0/turns>5", "badTrigger"},
                                    {"4.0 --trigger Ring/in.5", "badTrigger"},
                                    {"4.0 --trigger 9.9/in.5", "unknownDevice"},
                                    {"4.0 --trigger Crane/fault", "unknownDevice"},
                                    {"4.0 --trigger 05/in.2", "noSuchBit"},
                                    {"4.0 --trigger 3.0/out.0", "noSuchBit"},
                                    {"4.0 --trigger 3.0/cams.0", "noSuchBit"}}) {
        const CliRun run = record(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(errorKey(run), key) << line;
        EXPECT_NE(run.exit, 0) << line;
        EXPECT_THAT(run.err, HasSubstr("codewheel-cli: ")) << line;
        EXPECT_FALSE(QFileInfo::exists(file)) << line;
    }
    EXPECT_EQ(errorKey(runLine(QStringLiteral("record 4.0 --for 1 --json"))), "missingFile");
}

TEST_F(CliRecord, NeverOverAnotherFile)
{
    QFile other(file);
    ASSERT_TRUE(other.open(QIODevice::WriteOnly));
    other.write("mine");
    other.close();
    const CliRun run = record(QStringLiteral("4.0 --for 1 --json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "recordingExists");
    EXPECT_EQ(QFileInfo(file).size(), 4);
}

TEST_F(CliRecord, WhereNothingCanBeWrittenItIsRefused)
{
    const CliRun run = runLine(QStringLiteral("record 4.0 --for 1 --json -o /proc/shaft.cwrec"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "databaseFailed");
}

TEST_F(CliRecord, AFullDiskIsToldAtOnceAndAtTheEnd)
{
    const CliRun run = record(QStringLiteral("4.0 --for 20 --keep-free 2000000000 --json"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "diskAlmostFull");
    EXPECT_THAT(run.err, HasSubstr("Make room."));
    EXPECT_THAT(run.err, HasSubstr("Not everything is in " + file.toStdString()));
}

TEST_F(CliRecord, WhatWasWrittenBeforeTheDiskWasFullIsThere)
{
    const CliRun run = [&] {
        const test::NoRoom full(300'000);
        return record(QStringLiteral("--link interbus:training --for 120 --keep-free 0 --json"));
    }();
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "databaseFailed");
    EXPECT_GT(samples(QStringLiteral("4.0"), Channel::position).size(), 1'000U);
    EXPECT_LT(secondsIn(run.json()), 110);
}

TEST_F(CliRecord, ALinkThatIsLostLeavesAGapAndTheRecordingGoesOn)
{
    SharedLine shared;
    shared.unplugAfter("05P", 100);
    const CliRun run = shared.runLine(QStringLiteral("record 05 --for 60 --json -o ") + file);
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "portLost");
    EXPECT_THAT(run.err, HasSubstr("The recording goes on, with a gap until the link is back."));
    EXPECT_TRUE(reader().head()->hasEnded);
    EXPECT_GT(secondsIn(run.json()), 0.5) << "what came before";
    EXPECT_LT(secondsIn(run.json()), 30);
    const auto messages = reader().messages({Instant(0), Instant::max()}, 100).value();
    EXPECT_TRUE(std::ranges::any_of(
        messages, [](const auto &message) { return message.message.code == QStringLiteral("portLost"); }));
}

class CliRecordProgram : public CliRecord
{
protected:
    ~CliRecordProgram() override
    {
        if (program.state() == QProcess::NotRunning)
            return;
        program.kill();
        program.waitForFinished(patience);
    }
    void start(const QString &line)
    {
        program.start(QStringLiteral(CODEWHEEL_CLI),
                      QStringLiteral("record -o %1 %2").arg(file, line).split(u' ', Qt::SkipEmptyParts));
        ASSERT_TRUE(program.waitForReadyRead(patience)) << program.readAllStandardError().toStdString();
    }
    int end(int signal)
    {
        ::kill(static_cast<pid_t>(program.processId()), signal);
        EXPECT_TRUE(program.waitForFinished(patience));
        return program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1;
    }

    QProcess program;
};

TEST_F(CliRecordProgram, CtrlCEndsItInGoodOrder)
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        QFile::remove(file);
        start(QStringLiteral("4.0 05"));
        waitForMore(program, 70'000);
        EXPECT_EQ(end(signal), 0) << signal;
        EXPECT_TRUE(reader().head()->hasEnded) << signal;
        EXPECT_THAT(program.readAllStandardOutput().toStdString(), HasSubstr("It ended at 2"));
        EXPECT_FALSE(samples(QStringLiteral("esc:05"), Channel::position).empty());
    }
}

TEST_F(CliRecordProgram, EndedBeforeTheTriggerThereIsNoFile)
{
    start(QStringLiteral("1.0 --trigger 1.0/in.31"));
    EXPECT_EQ(end(SIGINT), 1);
    EXPECT_THAT(program.readAllStandardError().toStdString(), HasSubstr("The trigger has not come."));
    EXPECT_FALSE(QFileInfo::exists(file));
}

TEST_F(CliRecordProgram, KilledAllUpToTheLastSecondIsThere)
{
    start(QStringLiteral("4.0"));
    QThread::sleep(4);
    end(SIGKILL);
    const auto all = samples(QStringLiteral("4.0"), Channel::position);
    ASSERT_FALSE(all.empty());
    EXPECT_FALSE(reader().head()->hasEnded);
    EXPECT_GT(all.back().at - all.front().at, 1'500ms);
}

TEST_F(CliRecordProgram, TwoDoNotRecordIntoOneFile)
{
    start(QStringLiteral("4.0"));
    waitForMore(program, 70'000);
    const CliRun second = record(QStringLiteral("4.0 --for 1 --json"));
    EXPECT_EQ(errorKey(second), "recordingExists");
    EXPECT_EQ(end(SIGINT), 0);
    EXPECT_TRUE(reader().head()->hasEnded);
}

} // namespace
} // namespace codewheel
