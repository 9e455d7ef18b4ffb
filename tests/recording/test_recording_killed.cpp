// SPDX-License-Identifier: GPL-3.0-or-later
// Killed at any time, a recording has everything that was written, and its pyramid.
#include "tests/recording/recording_file.h"
#include "tests/recording/recording_process.h"
#include "tests/support/times.h"

namespace codewheel {
namespace {

using namespace test;

TEST(RecordingKilled, HasEverythingThatWasWritten)
{
    const int kills = times(25);
    for (int kill = 0; kill < kills; ++kill) {
        const RecordingFile file;
        RecordingProcess child({file.path});
        child.waitFor(1 + QRandomGenerator::global()->bounded(40));
        const std::int64_t promised = child.kill();
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
