// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_runner.h"
#include "kinds/canopen/bus/canopen_traffic.h"
#include "replay/recorded_rows.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanopenTraffic : public test::CanopenPlant
{};

auto hasIdentifier(const QString &identifier)
{
    return [identifier](const TrafficRow &row) {
        return row.identifier && row.identifier->text() == identifier;
    };
}

TEST_F(CanopenTraffic, RowsSayIdentifierNodeAndMeaning)
{
    operate();
    std::vector<TrafficRow> told;
    QObject::connect(bus.get(), &EncoderBus::trafficPassed, bus.get(),
                     [&](const TrafficRow &row) { told.push_back(row); });
    bus->transfer({.node = 5, .object = {0x6004, 0}});
    bus->advance(10ms);
    const auto request = std::ranges::find_if(told, hasIdentifier(QStringLiteral("605")));
    ASSERT_NE(request, told.end());
    EXPECT_EQ(request->kind, TrafficKind::sent);
    EXPECT_EQ(request->place, five);
    EXPECT_EQ(byteText(request->bytes.sliced(request->head)), QStringLiteral("40 04 60 00 00 00 00 00"));
    EXPECT_EQ(request->meaning(), QStringLiteral("Node 5: read 6004h:0"));
    const auto answer = std::ranges::find_if(told, hasIdentifier(QStringLiteral("585")));
    ASSERT_NE(answer, told.end());
    EXPECT_GT(answer - request, 0);
    EXPECT_EQ(answer->kind, TrafficKind::answer);
    EXPECT_LE(request->at, answer->at);
    EXPECT_EQ(answer->meaning(), QStringLiteral("Node 5: 6004h:0 = 1388h = 5000"));
}

TEST_F(CanopenTraffic, WhatNodesAreAskedAgainAndAgainIsRoutine)
{
    operate();
    rows.clear();
    bus->advance(1s);
    EXPECT_GT(std::ranges::count_if(rows, &CanopenRow::isAutomatic), 20);
    rows.clear();
    bus->transfer({.node = 7, .object = {0x6004, 0}});
    bus->advance(10ms);
    EXPECT_EQ(std::ranges::count_if(
                  rows, [](const CanopenRow &row) { return row.frame.id == 0x607 && row.isAutomatic; }),
              0);
}

TEST(CanopenRows, FiveSecondsOfAFullBusWaitForABusyWindow)
{
    constexpr std::size_t frames = 5 * 10'400;
    CanopenRunner::Mail mail;
    for (std::size_t i = 0; i < frames; ++i)
        mail.tell({.what = CanopenRow{}});
    EXPECT_EQ(mail.droppedRows(), 0U);
    EXPECT_EQ(mail.takeEvents().size(), frames);
}

TEST(CanopenRows, FramesAreReadAgainFromTheirBytes)
{
    CanFrame remote{.id = 0x705, .isRemote = true, .length = 1};
    CanFrame error{.id = 0x020, .isError = true, .length = 8, .bytes = {0, 4}};
    CanFrame extended = test::canFrame(0x0CFF'E0E0, {1, 2, 3});
    extended.isExtended = true;
    for (const CanFrame &frame :
         {test::canFrame(0x185, {0x88, 0x13, 0, 0}), test::canFrame(0x080, {}), remote, error, extended})
        EXPECT_EQ(canFrameOf(frameBytes(frame)), frame);
    EXPECT_EQ(frameBytes(test::canFrame(0x185, {0x88, 0x13})).toHex(), QByteArray("000001858813"));
    EXPECT_FALSE(canFrameOf(QByteArray("abc")));
    EXPECT_FALSE(canFrameOf(QByteArray(13, 'a')));
}

TEST(CanopenRows, OfARecordingAreExplained)
{
    const auto recorded = makeCanopenRows();
    const TrafficRow row = recorded->explained(
        {.kind = TrafficKind::answer, .bytes = frameBytes(test::canFrame(0x705, {0}))}, {});
    EXPECT_TRUE(hasIdentifier(QStringLiteral("705"))(row));
    EXPECT_EQ(row.meaning(), QStringLiteral("Node 5: boot-up"));
    EXPECT_FALSE(recorded->explained({.bytes = "?"}, {}).meaning);
}

} // namespace
} // namespace codewheel
