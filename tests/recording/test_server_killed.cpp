// SPDX-License-Identifier: GPL-3.0-or-later
// What a killed program could not send is sent by the next one.
#include "tests/recording/recording_process.h"
#include "tests/recording/server_fixture.h"

namespace codewheel {
namespace {

using namespace test;

TEST_F(ServerRecordings, WhatAKilledProgramLeftIsSentByTheNextOne)
{
    for (const bool isAway : {false, true}) {
        address = server->newDatabase();
        RecordingProcess child({file.folder(), address});
        child.waitFor(1 + QRandomGenerator::global()->bounded(10));
        if (isAway) {
            server->stop();
            child.waitFor(5);
        }
        const std::int64_t promised = child.kill();
        if (isAway)
            server->start();
        ASSERT_EQ(waitingFiles().size(), 1);
        const QString left =
            address + QStringLiteral("?recording=") + QFileInfo(waitingFiles().front()).completeBaseName();
        const auto next = begin(settings());
        while (waitingFiles().size() > 1)
            next->flush();
        EXPECT_FALSE(next->end().problem);
        EXPECT_EQ(waitingFiles().size(), 0);
        const RecordingReader there = reader(left);
        EXPECT_FALSE(there.head()->hasEnded) << "nobody knows when";
        RecordedChannel channel = RecordingFile::channel(there, Channel::position);
        const auto samples = samplesOf(channel);
        ASSERT_GE(std::ssize(samples), promised);
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_EQ(samples[i], (Sample{1ms * (i + 1), static_cast<std::int64_t>(i + 1)}));
        EXPECT_GE(std::ssize(*there.messages({Instant(0), Instant::max()}, 1'000'000)), promised / 300);
        EXPECT_FALSE(channel.damage());
    }
}

} // namespace
} // namespace codewheel
