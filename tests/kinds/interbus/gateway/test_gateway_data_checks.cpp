// SPDX-License-Identifier: GPL-3.0-or-later
// Why there is no data of a ring behind a gateway.
#include "bus/bus_outline.h"
#include "bus/data_check.h"
#include "kinds/interbus/ring/ring_checks.h"
#include "tests/support/gateway_session.h"

namespace codewheel::test {
namespace {

using namespace std::chrono_literals;

const DataCheck *orderOf(const DataChecks &checks)
{
    return findCheck(checks, DataCheck::Id::order);
}

void advanceInFrames(const GatewaySession &gateway, Instant duration)
{
    constexpr Instant frame = 50ms;
    for (Instant passed{}; passed < duration; passed += frame)
        gateway.bus->advance(frame);
}

TEST(GatewayDataChecks, AWordInTheOrderThatIsSetIsAsExpected)
{
    GatewaySession gateway;
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    const DataChecks checks = gateway.bus->dataChecks("2.0"_ring.node, {});
    EXPECT_NE(findCheck(checks, DataCheck::Id::gateway), nullptr);
    ASSERT_NE(orderOf(checks), nullptr);
    EXPECT_EQ(orderOf(checks)->outcome, DataCheck::Outcome::asExpected);
    EXPECT_EQ(orderOf(checks)->expected, QStringLiteral("high word first"));
}

// What the project says of a device is nothing that came.
TEST(GatewayDataChecks, WhichDeviceIsThereIsNotSaidByAGateway)
{
    GatewaySession gateway;
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    const DataChecks checks =
        gateway.bus->dataChecks("2.0"_ring.node, participantsOf(gateway.bus->structure()));
    EXPECT_EQ(findCheck(checks, DataCheck::Id::kind)->came, QStringLiteral("the gateway does not say"));
    EXPECT_EQ(findCheck(checks, DataCheck::Id::reached)->came, QStringLiteral("its registers are read"));
}

TEST(GatewayDataChecks, AWrongWordOrderIsToldWithTheOneThatWouldFit)
{
    GatewaySession gateway({.settings = {.highWordFirst = false}});
    gateway.ring->setSpeed("2.0"_ring.node, 0);
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    const DataChecks checks = gateway.bus->dataChecks("2.0"_ring.node, {});
    const DataCheck *first = firstDifference(checks);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->id, DataCheck::Id::order) << first->what.toStdString();
    EXPECT_TRUE(first->remedy.contains(QStringLiteral("It can with high word first")))
        << first->remedy.toStdString();
    EXPECT_EQ(first->action, DataCheck::Action::registers);
}

TEST(GatewayDataChecks, AWrongWordOrderShowsInTheBusStructure)
{
    GatewaySession gateway({.settings = {.highWordFirst = false}});
    gateway.ring->setSpeed("2.0"_ring.node, 0);
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    const auto row = [&] { return gateway.bus->outline().state(1); };
    advanceInFrames(gateway, 100ms);
    EXPECT_NE(row().shown.word, QStringLiteral("doubtful")) << "one word may be torn";
    advanceInFrames(gateway, 2s);
    EXPECT_EQ(row().shown.word, QStringLiteral("doubtful"));
    EXPECT_EQ(row().shown.role, Role::attention);
    EXPECT_TRUE(encoderFault(*gateway.bus, 1)->text.startsWith(QStringLiteral("2.0: IN is ")));
}

// By chance it looks like error 14 of the encoder, whose battery is low.
TEST(GatewayDataChecks, AnErrorInTheWrongWordOrderIsNotTold)
{
    constexpr std::int64_t looksLikeAnError = 0x000E'8000; // 8000000E
    for (const bool isRight : {true, false}) {
        GatewaySession gateway({.settings = {.highWordFirst = isRight}});
        gateway.ring->setSpeed("2.0"_ring.node, 0);
        ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
        advanceInFrames(gateway, 2s);
        gateway.ring->turnTo("2.0"_ring.node, looksLikeAnError);
        advanceInFrames(gateway, 100ms);
        EXPECT_EQ(gateway.countOf(MessageId::deviceFault), 0U) << isRight;
        EXPECT_EQ(encoderFault(*gateway.bus, 1).has_value(), !isRight);
        if (!isRight) {
            EXPECT_EQ(encoderFault(*gateway.bus, 1)->shown.word, QStringLiteral("doubtful"));
        }
    }
}

// It goes on showing the words of a ring that stands still.
DataCheck runningOf(const GatewaySettings &settings)
{
    GatewaySession gateway({.settings = settings});
    EXPECT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    const DataChecks checks = gateway.bus->dataChecks("2.0"_ring.node, {});
    const DataCheck *running = findCheck(checks, DataCheck::Id::running);
    return running != nullptr ? *running : DataCheck{};
}

TEST(GatewayDataChecks, WithoutTheMeaningOfAStatusRegisterNobodySaysWhetherTheRingRuns)
{
    EXPECT_EQ(runningOf({}).outcome, DataCheck::Outcome::notKnown);
    EXPECT_EQ(runningOf({.statusRegister = 4}).outcome, DataCheck::Outcome::notKnown);
}

TEST(GatewayDataChecks, ADeviceThatTakesNoWordsIsNotToBeWritten)
{
    GatewaySession gateway;
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    EXPECT_EQ(findCheck(gateway.bus->dataChecks("3.0"_ring.node, {}), DataCheck::Id::writing), nullptr);
    EXPECT_NE(findCheck(gateway.bus->dataChecks("2.0"_ring.node, {}), DataCheck::Id::writing), nullptr);
}

// The mode of a FRABA encoder cannot be read.
TEST(GatewayDataChecks, AnUnknownModeIsToBeToldByTheUser)
{
    GatewaySession gateway;
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    const auto position = [&] {
        const DataChecks checks = gateway.bus->dataChecks("1.0"_ring.node, {});
        return *findCheck(checks, DataCheck::Id::position);
    };
    EXPECT_EQ(position().outcome, DataCheck::Outcome::differs);
    EXPECT_EQ(position().action, DataCheck::Action::positionMode);
    gateway.encoder("1.0"_ring).tell(Parameter::startUpMode, 0);
    gateway.bus->advance(100ms);
    EXPECT_EQ(position().outcome, DataCheck::Outcome::asExpected) << position().remedy.toStdString();
}

TEST(GatewayDataChecks, ARightWordOrderIsNoDoubt)
{
    GatewaySession gateway;
    gateway.ring->setSpeed("2.0"_ring.node, 0);
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    advanceInFrames(gateway, 2s);
    EXPECT_FALSE(encoderFault(*gateway.bus, 1));
}

TEST(GatewayDataChecks, AWrongWordOrderOfAShaftThatTurnsIsSuspected)
{
    GatewaySession gateway({.settings = {.highWordFirst = false}});
    gateway.ring->setSpeed("2.0"_ring.node, 600);
    ASSERT_TRUE(gateway.bus->open(RingSession::Start::watching));
    gateway.bus->advance(2s);
    const DataChecks checks = gateway.bus->dataChecks("2.0"_ring.node, {});
    const DataCheck *first = firstDifference(checks);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->id, DataCheck::Id::reached) << first->what.toStdString();
    EXPECT_TRUE(first->remedy.contains(QStringLiteral("Check the word order")))
        << first->remedy.toStdString();
    EXPECT_EQ(first->action, DataCheck::Action::registers);
}

} // namespace
} // namespace codewheel::test
