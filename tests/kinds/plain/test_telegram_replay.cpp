// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of encoders that are only asked, replayed and reported.
#include "bus/buses.h"
#include "project/bus_plans.h"
#include "replay/replay_bus.h"
#include "report/live_encoders.h"
#include "report/make_report.h"
#include "report/transfer_report.h"
#include "tests/kinds/plain/plain_recording.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class TelegramReplay : public testing::Test
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<test::PlainKind>()); }

    const Catalog catalog = Catalog::builtIn();
};

TEST_F(TelegramReplay, ShowsItsLinesPositionsAndValues)
{
    const test::PlainRecording recording(catalog, test::telegramStations());
    EXPECT_TRUE(recording.rows.contains(QStringLiteral("sent at: position?")));
    EXPECT_TRUE(recording.rows.contains(QStringLiteral("answer none: it has no values yet")));
    const QString given =
        QStringLiteral("sent all steps=4096 direction=0 2000:1=-5 1008=Hoist%202: "
                       "Steps := 4096, Direction := 0 (CW), Filter := -5, Device name := Hoist "
                       "2");
    EXPECT_TRUE(recording.rows.contains(given))
        << recording.rows.filter(QStringLiteral("all ")).join(u'\n').toStdString();
    const std::shared_ptr<Playback> playback = *Playback::open(recording.path);
    ReplayBus bus(playback, test::plainId, BusId{1'001}, QStringLiteral("night"), catalog);
    playback->jumpTo(playback->span().to);
    bus.pump();
    const EncoderSession &encoder = *bus.encoder({BusId{1'001}, test::telegramWinch.node});
    EXPECT_EQ(encoder.device().key, QStringLiteral("telegram-node"));
    EXPECT_EQ(encoder.latest().position, recording.position);
    EXPECT_EQ(encoder.known(test::plainFilter())->value, -5);
}

TEST_F(TelegramReplay, AReportCountsNoWrites)
{
    test::PlainBus bus(catalog, test::telegramStations());
    bus.setOperate(true);
    Buses buses;
    buses.add(bus);
    EXPECT_TRUE(bus.encoder(test::telegramWinch)
                    ->start(WriteParameters{.values = {{test::plainFilter(), -5}}, .previous = {}}));
    bus.advance(std::chrono::milliseconds(20));
    ReportInput input;
    planBus(input.project, test::plainId, *busKind(u"plain"));
    std::vector<ProjectDevice> devices;
    for (const Place place : bus.places()) {
        devices.emplace_back().participant = *bus.found(place);
        devices.back().standAt(place);
        devices.back().wanted = {{test::plainFilter(), -5}};
    }
    setDevicesOn(input.project, test::plainId, std::move(devices));
    addConnected(input, buses);
    const std::string text = reportAsText(makeReport(input, catalog)).toStdString();
    EXPECT_THAT(text, HasSubstr("Filter           -5      -5         confirmed, not stored"));
    EXPECT_THAT(text, HasSubstr("n:4                0         this connection only"));
}

} // namespace
} // namespace codewheel
