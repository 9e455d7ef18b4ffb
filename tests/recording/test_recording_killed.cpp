// SPDX-License-Identifier: GPL-3.0-or-later
// Killed at any time, a recording has everything that was written, and its pyramid.
#include "tests/recording/recording_file.h"
#include "tests/support/times.h"

#include <QProcess>
#include <QRandomGenerator>
#include <QThread>

namespace codewheel {
namespace {

using namespace test;

constexpr int generous = 120'000; // ms

// Runs the child until it has printed this many lines, then kills it; returns what it last promised.
std::int64_t recordAndKill(const RecordingFile &file, int lines)
{
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QStringLiteral(RECORDING_CHILD), {file.path});
    EXPECT_TRUE(child.waitForStarted(generous));
    std::int64_t promised = 0;
    for (int line = 0; line < lines; ++line) {
        while (!child.canReadLine())
            if (!child.waitForReadyRead(generous)) {
                ADD_FAILURE() << "the child says nothing";
                return promised;
            }
        promised = child.readLine().trimmed().toLongLong();
    }
    QThread::usleep(
        static_cast<unsigned long>(QRandomGenerator::global()->bounded(20'000))); // in the middle of it
    child.kill();                                                                 // SIGKILL
    EXPECT_TRUE(child.waitForFinished(generous));
    while (child.canReadLine()) // said before it was killed
        promised = child.readLine().trimmed().toLongLong();
    return promised;
}

TEST(RecordingKilled, HasEverythingThatWasWritten)
{
    const int kills = times(25);
    for (int kill = 0; kill < kills; ++kill) {
        const RecordingFile file;
        const std::int64_t promised = recordAndKill(file, 1 + QRandomGenerator::global()->bounded(40));
        const RecordingReader reader = file.reader();
        EXPECT_FALSE(reader.head()->hasEnded);
        RecordedChannel channel = file.channel(reader, Channel::position);
        const auto samples = samplesOf(channel);
        ASSERT_GE(std::ssize(samples), promised);
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_EQ(samples[i], (Sample{1ms * (i + 1), static_cast<std::int64_t>(i + 1)}));
        RecordedChannel words = file.channel(reader, Channel::in);
        ASSERT_EQ(samplesOf(words).size(), samples.size());
        ASSERT_GE(std::ssize(*reader.messages({Instant(0), Instant::max()}, 1'000'000)), promised / 300);
        ASSERT_EQ(channel.look(*channel.span(), 3)->columns.at(2)->last, samples.back().value);
        ASSERT_FALSE(channel.damage());
        ASSERT_EQ(file.execute(QStringLiteral("PRAGMA integrity_check")), QStringLiteral("ok"));
    }
}

} // namespace
} // namespace codewheel
