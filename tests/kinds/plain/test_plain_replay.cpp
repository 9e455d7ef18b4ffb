// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of a kind of bus that replay does not know.
#include "replay/replay_bus.h"
#include "tests/kinds/plain/plain_recording.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class PlainReplay : public testing::Test
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<test::PlainKind>()); }

    const Catalog catalog = Catalog::builtIn();
    const test::PlainRecording recording{catalog};
    const std::shared_ptr<Playback> playback = *Playback::open(recording.path);
    ReplayBus bus{playback, test::plainId, {1'001}, QStringLiteral("night"), catalog};
    const Place hoist{{1'001}, test::plainHoist.node};
};

TEST_F(PlainReplay, ItsRowsHaveTheColumnsAndTheMeaningsOfTheirKind)
{
    ASSERT_TRUE(recording.rows.contains(QStringLiteral("sent set 2000:1=-5 1008=Hoist%202: "
                                                       "Filter := -5, Device name := Hoist 2")))
        << recording.rows.join(u'\n').toStdString();
    QStringList rows;
    QObject::connect(&bus, &EncoderBus::trafficPassed, &bus, [&](const TrafficRow &row) {
        EXPECT_EQ(row.place, hoist);
        rows << test::PlainRecording::text(row);
    });
    playback->play(Playback::Direction::forward);
    bus.advance(1s);
    EXPECT_EQ(rows.join(u'\n').toStdString(), recording.rows.join(u'\n').toStdString());
    EXPECT_TRUE(std::ranges::equal(bus.trafficColumns(), test::plainColumns));
    EXPECT_FALSE(bus.hasTerminal());
}

TEST_F(PlainReplay, ShowsItsPositionsNumbersAndTexts)
{
    playback->jumpTo(playback->span().to);
    bus.pump();
    const EncoderSession &encoder = *bus.encoder(hoist);
    EXPECT_EQ(encoder.device().key, QStringLiteral("plain-node"));
    EXPECT_EQ(encoder.latest().position, recording.position);
    EXPECT_EQ(encoder.known(test::plainFilter())->value, -5);
    EXPECT_EQ(encoder.known(test::plainName())->value, Value(QStringLiteral("Hoist 2")));
    EXPECT_EQ(bus.channel(hoist), nullptr) << "it has no words";
}

} // namespace
} // namespace codewheel
