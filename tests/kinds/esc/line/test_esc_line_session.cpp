// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "catalog/catalog.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "tests/kinds/esc/line/scripted_line.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

const QString rs485 = QStringLiteral("kuebler-esc-rs485");

class EscLineSessionTest : public testing::Test
{
protected:
    EscLineSessionTest()
    {
        auto made = std::make_unique<ScriptedLink>();
        link = made.get();
        link->answers = {{"\x1B"
                          "05P\r\n",
                          "\r\n00001235\r\n"}};
        line = std::make_unique<EscLineSession>(
            std::move(made), catalog, QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
            [this](const DeviceDescription &, EscLineAddress address) {
                auto driver = std::make_unique<PollingDriver>(address, 10ms);
                drivers.push_back(driver.get());
                return driver;
            });
        QObject::connect(line.get(), &EscLineSession::messaged, line.get(),
                         [this](const Message &message) { messages.push_back(message); });
    }

    const Catalog catalog = Catalog::builtIn();
    ScriptedLink *link = nullptr;
    std::vector<PollingDriver *> drivers;
    std::vector<Message> messages;
    std::unique_ptr<EscLineSession> line;
};

TEST_F(EscLineSessionTest, ShowsAnEncoderByItsAddress)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    const auto place = placeOnLine({5});
    EXPECT_EQ(line->places(), std::vector{place});
    EncoderSession *encoder = line->encoder(place);
    ASSERT_NE(encoder, nullptr);
    EXPECT_EQ(encoder->latest().state, EncoderState::notSeen);
    line->advance(50ms);
    EXPECT_EQ(encoder->latest().position, 0x1235);
    EXPECT_GT(line->shown(place)->figures.answers, 2U);
}

TEST_F(EscLineSessionTest, ThePaceOfTheLineSaysWhenAPositionIsOld)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    line->advance(500ms);
    const EncoderSession *encoder = line->encoder(placeOnLine({5}));
    EXPECT_TRUE(encoder->freshness().isLive());
    EXPECT_EQ(line->shown(placeOnLine({5}))->lateAfter, 1s);
}

TEST_F(EscLineSessionTest, WhatADriverSaysStandsAtThePlaceOnItsOwnLine)
{
    constexpr BusId fourth{4};
    auto made = std::make_unique<ScriptedLink>();
    PollingDriver *driver = nullptr;
    EscLineSession other(
        std::move(made), catalog, QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
        [&](const DeviceDescription &, EscLineAddress address) {
            auto polling = std::make_unique<PollingDriver>(address, 10ms);
            driver = polling.get();
            return polling;
        },
        nullptr, fourth);
    std::vector<Message> said;
    QObject::connect(&other, &EscLineSession::messaged, &other,
                     [&](const Message &message) { said.push_back(message); });
    ASSERT_TRUE(other.open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(other.add({5}, rs485));
    driver->say({.id = MessageId::encoderSilent});
    other.advance(1s);
    const auto found = std::ranges::find(said, MessageId::encoderSilent, &Message::id);
    ASSERT_NE(found, said.end());
    EXPECT_EQ(found->place, (Place{fourth, EscLineAddress{5}.node()}));
}

// Nothing is asked after it that could show it.
TEST_F(EscLineSessionTest, TheEndOfASearchShowsWhereNobodyIsPolled)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    line->scan({.baudRates = {19'200}, .first = {1}, .last = {2}});
    line->advance(10ms);
    EXPECT_EQ(line->outline().state().word, QStringLiteral("searching"));
    line->advance(10s);
    EXPECT_NE(line->outline().state().word, QStringLiteral("searching"));
}

TEST_F(EscLineSessionTest, WhatIsShownIsOldOncePollingStops)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    const EncoderSession *encoder = line->encoder(placeOnLine({5}));
    EXPECT_EQ(encoder->freshness().state(), Freshness::State::unknown);
    line->advance(50ms);
    EXPECT_TRUE(encoder->freshness().isLive());
    line->setRunning(false);
    line->advance(50ms);
    EXPECT_EQ(encoder->freshness().reason(), Freshness::Reason::stopped);
    line->setRunning(true);
    line->advance(50ms);
    EXPECT_TRUE(encoder->freshness().isLive());
    line->close();
    EXPECT_EQ(encoder->freshness().reason(), Freshness::Reason::disconnected);
}

TEST_F(EscLineSessionTest, AfterTheComputerSleptTheLineIsInWatch)
{
    std::atomic<std::int64_t> slept{0}; // ms
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byThread,
                           [&slept] { return std::chrono::milliseconds(slept); }));
    ASSERT_TRUE(line->add({5}, rs485));
    while (!line->encoder(placeOnLine({5}))->freshness().isLive())
        line->pump();
    slept = 3'600'000;
    const auto told = [this] {
        return std::ranges::find(messages, MessageId::computerSlept, &Message::id) != messages.end();
    };
    while (!told() || line->isOperating())
        line->pump();
    EXPECT_FALSE(line->isOperating());
    EXPECT_TRUE(line->latest().running);
    EXPECT_EQ(line->encoder(placeOnLine({5}))->start(SetPreset{1}).error().id, RefusalId::watchOnly);
    line->close();
}

TEST_F(EscLineSessionTest, RefusesAddressesThatCannotBe)
{
    EXPECT_EQ(line->add({5}, rs485).error().id, RefusalId::lineClosed);
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    EXPECT_EQ(line->add({32}, rs485).error().id, EscRefusalId::lineAddressWrong);
    EXPECT_EQ(line->add({5}, QStringLiteral("fraba-ocd-ib")).error().id, RefusalId::unknownDevice);
    ASSERT_TRUE(line->add({5}, rs485));
    EXPECT_EQ(line->add({5}, rs485).error().id, RefusalId::lineAddressTaken);
}

// Manual, "Masteraddress: 00": for an encoder of unknown address; all encoders answer to it.
TEST_F(EscLineSessionTest, TheMasterAddressIsForAnEncoderThatIsAlone)
{
    link->answers["\x1B"
                  "00P\r\n"] = "\r\n00001235\r\n";
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add(EscLineAddress::master(), rs485));
    const auto place = placeOnLine(EscLineAddress::master());
    EXPECT_EQ(line->places(), std::vector{place});
    ASSERT_NE(line->encoder(place), nullptr);
    line->advance(50ms);
    EXPECT_EQ(line->encoder(place)->latest().position, 0x1235);
    EXPECT_EQ(line->add({5}, rs485).error(),
              (Refusal{RefusalKind::badInput,
                       EscRefusalId::lineAddressNotAlone,
                       {QStringLiteral("00h (0)"), QStringLiteral("esc:05")}}));
    ASSERT_TRUE(line->remove(place));
    ASSERT_TRUE(line->add({5}, rs485));
    EXPECT_EQ(line->add(EscLineAddress::master(), rs485).error(),
              (Refusal{RefusalKind::badInput,
                       EscRefusalId::lineAddressNotAlone,
                       {QStringLiteral("00h (0)"), QStringLiteral("esc:05")}}));
}

TEST_F(EscLineSessionTest, InWatchAnEncoderTakesNoWrite)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    EncoderSession *encoder = line->encoder(placeOnLine({5}));
    EXPECT_EQ(encoder->start(SetPreset{1}).error().id, RefusalId::watchOnly);
    line->setOperate(true);
    line->advance(50ms);
    EXPECT_TRUE(line->isOperating());
    EXPECT_TRUE(encoder->start(SetPreset{1}));
    EXPECT_EQ(encoder->start(SetPreset{1}).error().id, RefusalId::jobRunning);
}

// As the night's messages have to show why a position jumped.
TEST_F(EscLineSessionTest, SaysWhatWasWrittenByHandAndWhetherItIsKnown)
{
    link->answers["\x1B"
                  "05GP00001770\r\n"] = "\r\n";
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    line->advance(50ms);
    const auto send = [this](std::uint32_t position) {
        messages.clear();
        line->send({.to = {5}, .command = esc::Command::writePreset, .data = position});
        line->advance(5s);
    };
    send(0x1770);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages.front().place, placeOnLine({5}));
    const QString told = messageText(messages.front());
    EXPECT_TRUE(told.startsWith(QStringLiteral("Written by hand: 05: "))) << told.toStdString();
    EXPECT_TRUE(told.endsWith(QStringLiteral("= 6000 (05GP00001770). EEPROM writes: 1.")))
        << told.toStdString();
    send(0x1771); // nobody answers
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages.front().id, MessageId::inDoubt);
    EXPECT_EQ(messages.front().severity, Severity::attention);
    EXPECT_TRUE(messageText(messages.front()).contains(QStringLiteral("= 6001 (05GP00001771). Read it")))
        << messageText(messages.front()).toStdString();
}

TEST_F(EscLineSessionTest, AnEncoderWithAnotherAddressIsFoundByThatOne)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    line->advance(20ms);
    EncoderSession *encoder = line->encoder(placeOnLine({5}));
    std::vector<std::pair<Place, Place>> moves;
    QObject::connect(line.get(), &EscLineSession::moved, line.get(),
                     [&](Place from, Place to) { moves.emplace_back(from, to); });
    drivers.front()->moveTo({0x12});
    line->advance(200ms);
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_EQ(moves.front(), std::pair(placeOnLine({5}), placeOnLine({0x12})));
    EXPECT_EQ(line->encoder(placeOnLine({0x12})), encoder);
    EXPECT_EQ(line->encoder(placeOnLine({5})), nullptr);
}

TEST_F(EscLineSessionTest, AnEncoderAddedLaterHasTheFractionBitsOfTheLine)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    line->setFractionBits(28);
    line->advance(50ms);
    EXPECT_EQ(drivers.front()->fractionBits(), 28);
    ASSERT_TRUE(line->add({6}, rs485));
    line->advance(50ms);
    EXPECT_EQ(drivers.back()->fractionBits(), line->fractionBits());
}

TEST_F(EscLineSessionTest, ARemovedEncoderIsAskedNoMore)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    line->advance(50ms);
    ASSERT_TRUE(line->remove(placeOnLine({5})));
    line->advance(50ms);
    const auto sent = link->sent.size();
    line->advance(500ms);
    EXPECT_EQ(link->sent.size(), sent);
    EXPECT_TRUE(line->places().empty());
    EXPECT_TRUE(line->add({5}, rs485)); // its address is free again
    line->advance(500ms);
    EXPECT_GT(link->sent.size(), sent);
}

TEST_F(EscLineSessionTest, AsksBeforeAnotherAdapterIsUsed)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    ASSERT_TRUE(line->add({5}, rs485));
    line->advance(50ms);
    std::vector<Refusal> asked;
    QObject::connect(line.get(), &EscLineSession::otherAdapterFound, line.get(),
                     [&](const Refusal &which) { asked.push_back(which); });
    link->unplugged = true;
    line->advance(50ms);
    EXPECT_FALSE(line->isRunning());
    link->unplugged = false;
    link->isOther = true;
    line->advance(5s);
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(asked.front().id, RefusalId::portOfOther);
    EXPECT_FALSE(line->isRunning());
    line->takeOtherAdapter();
    line->advance(50ms);
    EXPECT_TRUE(line->isRunning());
}

TEST_F(EscLineSessionTest, SaysThatItWasOpenedAndClosed)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand));
    line->close();
    ASSERT_GE(messages.size(), 2U);
    EXPECT_EQ(messages.front().id, EscMessageId::lineOpened);
    EXPECT_EQ(messages.back().id, EscMessageId::lineClosed);
    EXPECT_FALSE(line->isOpen());
}

TEST_F(EscLineSessionTest, RunsInAThreadOfItsOwn)
{
    ASSERT_TRUE(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byThread));
    ASSERT_TRUE(line->add({5}, rs485));
    while (line->latest().figures.answers < 100)
        line->pump();
    line->close();
    EXPECT_EQ(line->encoder(placeOnLine({5}))->latest().position, 0x1235);
}

TEST_F(EscLineSessionTest, APortThatCannotBeOpenedIsRefused)
{
    link->unplugged = true;
    EXPECT_EQ(line->open({}, {}, EscLineSession::Start::watching, EscLineSession::Drive::byHand).error().id,
              RefusalId::portNotFound);
    EXPECT_FALSE(line->isOpen());
}

} // namespace
} // namespace codewheel
