// SPDX-License-Identifier: GPL-3.0-or-later
// What is done by hand on the bus: frames, transfers, searching, LSS.
#include "bus/bus_outline.h"
#include "journal/ledger_keeper.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::LssOutcome;
using canopen::LssRequest;
using canopen::SdoOutcome;

class CanopenByHand : public test::CanopenPlant
{
protected:
    void hear()
    {
        QObject::connect(bus.get(), &CanopenSession::frameSent, bus.get(),
                         [this](const FrameSent &sent) { frames.push_back(sent); });
        QObject::connect(bus.get(), &CanopenSession::transferEnded, bus.get(),
                         [this](const TransferEnded &ended) { transfers.push_back(ended); });
        QObject::connect(bus.get(), &CanopenSession::configured, bus.get(),
                         [this](const Configured &ended) { lss.push_back(ended); });
        QObject::connect(bus.get(), &CanopenSession::scanned, bus.get(),
                         [this](const NodesScanned &scan) { scans.push_back(scan); });
    }
    std::optional<LssOutcome> configure(const LssRequest &request)
    {
        lss.clear();
        bus->configure(request);
        for (int i = 0; i < 400 && lss.empty(); ++i)
            bus->advance(50ms);
        return lss.empty() ? std::nullopt : std::optional(lss.front().outcome);
    }

    std::vector<FrameSent> frames;
    std::vector<TransferEnded> transfers;
    std::vector<Configured> lss;
    std::vector<NodesScanned> scans;
};

// Nobody has looked since: a question was open.
TEST_F(CanopenByHand, WhatHasComeInIsReadBeforeACommandIsCarriedOut)
{
    operate();
    hear();
    link->sent.clear();
    say(canopen::syncFrame());
    plant->bus()->advance(plant->bus()->now() + 3s);
    bus->transfer({.node = 5, .object = {0x1018, 1}});
    bus->advance(100ms);
    EXPECT_TRUE(link->sent.empty()) << "another master is at work by now";
    ASSERT_EQ(transfers.size(), 1U);
    EXPECT_NE(transfers.front().outcome.kind, SdoOutcome::Kind::read);
}

TEST_F(CanopenByHand, AfterAPauseWhatHasComeInIsReadBeforeAnythingIsAsked)
{
    operate();
    hear();
    link->sent.clear();
    plant->bus()->advance(plant->bus()->now() + 3s);
    bus->advance(1ms);
    EXPECT_FALSE(link->sent.empty()) << "encoders are asked";
    link->sent.clear();
    say(canopen::syncFrame());
    plant->bus()->advance(plant->bus()->now() + 3s);
    bus->advance(100ms);
    EXPECT_TRUE(link->sent.empty()) << "another master is at work by now";
}

TEST_F(CanopenByHand, AFrameIsSentOnceInOperate)
{
    open(EncoderBus::Start::watching);
    hear();
    const CanFrame start = test::canFrame(0, {1, 6});
    bus->send(start);
    bus->advance(10ms);
    ASSERT_EQ(frames.size(), 1U);
    ASSERT_TRUE(frames.front().refused);
    EXPECT_EQ(frames.front().refused->id, RefusalId::watchOnly);
    bus->setOperate(true);
    bus->advance(100ms);
    bus->send(start);
    bus->advance(100ms);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames.back().fate, CanFate::done);
    EXPECT_EQ(sentTo(0), 1);
    EXPECT_EQ(stateOf(1), canopen::NmtState::operational);
    const auto row =
        std::ranges::find_if(rows, [](const CanopenRow &each) { return each.isSent && each.isTyped; });
    ASSERT_NE(row, rows.end());
    EXPECT_EQ(row->frame.id, 0U);
}

TEST_F(CanopenByHand, TheAnswerToAnSdoFrameByHandIsNobodyElses)
{
    operate();
    bus->send(test::canFrame(0x605, {0x40, 0x08, 0x65, 0, 0, 0, 0, 0}));
    bus->advance(200ms);
    EXPECT_EQ(bus->latest().figures.answersOfOthers, 0U);
}

TEST_F(CanopenByHand, AnObjectIsReadAndWritten)
{
    operate();
    hear();
    bus->transfer({.node = 7, .object = {0x1008, 0}});
    bus->advance(300ms);
    ASSERT_EQ(transfers.size(), 1U);
    EXPECT_EQ(transfers.front().outcome.kind, SdoOutcome::Kind::read);
    const auto &value = transfers.front().outcome.value;
    EXPECT_EQ(std::string(value.begin(), value.end()), "SIMLIN-CO");
    bus->transfer({.node = 6, .object = {0x6200, 0}, .value = std::vector<std::uint8_t>{0x64, 0}});
    bus->transfer({.node = 6, .object = {0x6200, 0}});
    bus->advance(300ms);
    ASSERT_EQ(transfers.size(), 3U);
    EXPECT_EQ(transfers[1].outcome.kind, SdoOutcome::Kind::written);
    EXPECT_EQ(canopen::numberOf(transfers[2].outcome.value), 100U);
}

TEST_F(CanopenByHand, WhatIsWrittenByHandIsToldAndWhatIsRefusedIsNot)
{
    operate();
    messages.clear();
    bus->transfer({.node = 6, .object = {0x6001, 0}, .value = std::vector<std::uint8_t>{0, 8, 0, 0}});
    bus->transfer({.node = 6, .object = {0x6004, 0}, .value = std::vector<std::uint8_t>{0, 8, 0, 0}});
    bus->transfer({.node = 6, .object = {0x6001, 0}});
    bus->advance(500ms);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].id, CanopenBusMessageId::objectWritten);
    EXPECT_EQ(messages[0].arguments,
              (std::vector<RefusalArgument>{QStringLiteral("6001h:0"), QStringLiteral("00000800h")}));
}

TEST_F(CanopenByHand, ACommandIsNotCalledSentWhereTheAdapterDoesNotTell)
{
    operate();
    messages.clear();
    link->tellsFates = false;
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(100ms);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].id, CanopenBusMessageId::nmtInDoubt);
    EXPECT_EQ(messages[0].severity, Severity::attention);
    EXPECT_TRUE(messageText(messages[0]).endsWith(QStringLiteral("It was start node 6.")))
        << messageText(messages[0]).toStdString();
}

TEST_F(CanopenByHand, StoringByHandIsAccountedFor)
{
    operate();
    hear();
    std::vector<TypedWrite> writes;
    std::vector<TypedEnd> ends;
    QObject::connect(bus.get(), &EncoderBus::writeAboutToBeSent, bus.get(),
                     [&](const TypedWrite &write) { writes.push_back(write); });
    QObject::connect(bus.get(), &EncoderBus::typedWriteEnded, bus.get(),
                     [&](const TypedWrite &, TypedEnd end) { ends.push_back(end); });
    bus->transfer({.node = 6,
                   .object = {0x1010, 1},
                   .value = std::vector<std::uint8_t>{0x73, 0x61, 0x76, 0x65},
                   .timeOut = 5s});
    ASSERT_EQ(writes.size(), 1U);
    EXPECT_EQ(writes.front().place, six);
    bus->advance(6s);
    EXPECT_EQ(ends, std::vector{TypedEnd::done});
    bus->send(test::canFrame(0x606, {0x23, 0x10, 0x10, 1, 0x73, 0x61, 0x76, 0x65}));
    EXPECT_EQ(writes.size(), 2U);
    bus->advance(1s);
    EXPECT_EQ(ends.size(), 2U);
}

// What was answered counts, what was refused does not, and of the rest nobody knows.
TEST_F(CanopenByHand, OneThatIsNotAnsweredIsPerhapsStored)
{
    const canopen::SdoRequest store{.node = 6,
                                    .object = {0x1010, 1},
                                    .value = std::vector<std::uint8_t>{0x73, 0x61, 0x76, 0x65},
                                    .timeOut = 5s};
    operate();
    const LedgerKeeper keeper(*bus, DatabasePlace::memory());
    const auto count = [this] { return bus->encoder(six)->eepromCount(); };
    bus->transfer(store);
    bus->advance(6s);
    EXPECT_EQ(count().writes, 1);
    canopen::SdoRequest refusedStore = store;
    refusedStore.value->front() = 0;
    bus->transfer(refusedStore);
    bus->advance(6s);
    EXPECT_EQ(count().atMost(), 1);
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.setOn(false); });
    bus->transfer(store);
    bus->advance(6s);
    EXPECT_EQ(count().writes, 1);
    EXPECT_EQ(count().perhaps, 1);
}

TEST_F(CanopenByHand, ATransferThatTheLinkBreaksIsNotKnown)
{
    operate();
    hear();
    link->goneAfter = [](const CanFrame &frame) { return frame.bytes[2] == 0x62; };
    bus->transfer({.node = 6, .object = {0x6200, 0}, .value = std::vector<std::uint8_t>{0x64, 0}});
    bus->advance(300ms);
    ASSERT_EQ(transfers.size(), 1U);
    EXPECT_EQ(transfers.front().outcome.kind, SdoOutcome::Kind::noAnswer);
    EXPECT_EQ(bus->state(), BusState::lost);
}

// It is on the bus.
TEST_F(CanopenByHand, ATransferThatWatchBreaksIsNotKnown)
{
    operate();
    hear();
    bus->transfer({.node = 100, .object = {0x1010, 1}, .value = std::vector<std::uint8_t>{1}, .timeOut = 5s});
    bus->advance(300ms);
    bus->setOperate(false);
    bus->advance(100ms);
    ASSERT_EQ(transfers.size(), 1U);
    EXPECT_EQ(transfers.front().outcome.kind, SdoOutcome::Kind::noAnswer);
}

TEST_F(CanopenByHand, NodesAreSearchedFor)
{
    operate();
    hear();
    bus->scan();
    bus->advance(100ms);
    EXPECT_EQ(bus->outline().state().role, Role::attention);
    EXPECT_FALSE(carryOut(five, ReadParameters{{Parameter::serialNumber}}));
    bus->advance(10s);
    ASSERT_FALSE(scans.empty());
    EXPECT_TRUE(scans.back().isDone);
    EXPECT_FALSE(scans.back().isCancelled);
    std::vector<int> found;
    for (const canopen::FoundNode &node : scans.back().found)
        found.push_back(node.node);
    EXPECT_EQ(found, (std::vector{5, 6, 7}));
    EXPECT_EQ(bus->latest().figures.answersOfOthers, 0U);
    EXPECT_EQ(bus->places().size(), 2U) << "it adds nobody";
    bus->advance(1s);
    EXPECT_TRUE(bus->encoder(five)->freshness().isLive());
}

TEST_F(CanopenByHand, ASearchFindsANodeThatWasAskedBeforeWhoItIs)
{
    operate();
    hear();
    for (const canopen::SdoObject object : {canopen::SdoObject{0x1000, 0}, {0x1018, 1}, {0x1018, 2}})
        bus->transfer({.node = 7, .object = object});
    bus->advance(1s);
    bus->scan();
    bus->advance(10s);
    ASSERT_FALSE(scans.empty());
    const auto &found = scans.back().found;
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[2].node, 7);
    EXPECT_EQ(found[2].deviceType, 0x0008'0196U);
    for (const auto &part : found[2].identity)
        EXPECT_TRUE(part);
    EXPECT_EQ(bus->latest().figures.lateAnswers, 0U);
}

TEST_F(CanopenByHand, ASearchIsCancelled)
{
    operate();
    hear();
    bus->scan();
    bus->advance(200ms);
    bus->cancelScan();
    bus->advance(10ms);
    ASSERT_FALSE(scans.empty());
    EXPECT_TRUE(scans.back().isDone && scans.back().isCancelled);
    EXPECT_FALSE(bus->latest().scanning);
}

TEST_F(CanopenByHand, ASearchEndsWhereNothingGoesOut)
{
    operate();
    hear();
    link->isFull = true;
    bus->scan();
    bus->advance(5s);
    EXPECT_TRUE(bus->latest().scanning) << "others are heard: a full queue means wait";
    bus->advance(30s);
    ASSERT_FALSE(scans.empty());
    EXPECT_TRUE(scans.back().isDone && scans.back().isCancelled);
}

TEST_F(CanopenByHand, AnIdentifierThatWasWrittenIsThatOfItsNode)
{
    operate();
    hear();
    for (const std::vector<std::uint8_t> &identifier : {std::vector<std::uint8_t>{0x85, 0x01, 0, 0xC0},
                                                        {0x89, 0x01, 0, 0x40}}) // off, and as that of node 9
        bus->transfer({.node = 5, .object = {0x1800, 1}, .value = identifier});
    bus->advance(1s);
    ASSERT_EQ(transfers.size(), 2U);
    EXPECT_EQ(transfers.back().outcome.kind, SdoOutcome::Kind::written);
    bus->send(test::canFrame(0, {1, 5}));
    bus->advance(2s);
    EXPECT_TRUE(std::ranges::any_of(rows, [](const CanopenRow &row) { return row.frame.id == 0x189; }));
    EXPECT_EQ(bus->latest().heard(9), nullptr);
    EXPECT_EQ(bus->latest().heard(5)->state, canopen::NmtState::operational);
    EXPECT_TRUE(bus->latest().heard(5)->sendsPdos);
}

TEST_F(CanopenByHand, ADeviceWithoutANumberGetsOneByLss)
{
    operate();
    hear();
    const auto found = configure({.kind = LssRequest::Kind::fastScan});
    ASSERT_TRUE(found);
    ASSERT_EQ(found->kind, LssOutcome::Kind::done);
    EXPECT_EQ(found->identity.serial(), 0x0013'0015U);
    EXPECT_EQ(configure({.kind = LssRequest::Kind::setNode, .number = 9})->kind, LssOutcome::Kind::done);
    EXPECT_EQ(configure({.kind = LssRequest::Kind::store})->kind, LssOutcome::Kind::done);
    EXPECT_EQ(configure({.kind = LssRequest::Kind::operateAll})->kind, LssOutcome::Kind::done);
    bus->advance(500ms);
    ASSERT_NE(bus->latest().heard(9), nullptr);
    EXPECT_EQ(bus->latest().heard(9)->bootUps, 1);
    EXPECT_TRUE(bus->encoder(five)->freshness().isLive()) << "the others are asked meanwhile";
}

TEST_F(CanopenByHand, LssIsRefusedInWatch)
{
    open(EncoderBus::Start::watching);
    hear();
    bus->configure({.kind = LssRequest::Kind::inquireNode});
    bus->advance(10ms);
    ASSERT_EQ(lss.size(), 1U);
    ASSERT_TRUE(lss.front().refused);
    EXPECT_EQ(lss.front().refused->id, RefusalId::watchOnly);
}

} // namespace
} // namespace codewheel
