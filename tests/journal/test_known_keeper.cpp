// SPDX-License-Identifier: GPL-3.0-or-later
// What was known of an encoder before its bus was connected anew.
#include "catalog/catalog.h"
#include "journal/known_keeper.h"
#include "journal/ledger_keeper.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/passing_link.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class RealLink : public test::PassingLink
{
public:
    using PassingLink::PassingLink;
    bool isSimulated() const override { return false; }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        return std::exchange(isToBeLost, false)
                   ? refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("no answer")})
                   : PassingLink::exchange(out, in);
    }

    static inline bool isToBeLost = false; // for a moment
};

const QDateTime begun(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC);

// A ring of which another Codewheel, or a spare part, may have taken care while it was not connected.
class KnownKeeperTest : public testing::Test
{
protected:
    KnownKeeperTest()
    {
        keeper.watch(bus);
        connect();
    }
    void connect()
    {
        ASSERT_TRUE(bus.open(RingSession::Start::operating));
        bus.advance(10);
    }
    void reconnect()
    {
        bus.close();
        bus.setTime(begun.addSecs(3'600));
        connect();
    }
    // The link is lost, and back a second later.
    void loseForAMoment()
    {
        RealLink::isToBeLost = true;
        bus.advance(10);
        ASSERT_EQ(bus.state(), BusState::lost);
        bus.advance(2'000);
        ASSERT_EQ(bus.state(), BusState::open);
    }
    // The same place, another encoder.
    void replaceRing()
    {
        bus.useLink(std::make_unique<RealLink>(makeTrainingBus(catalog).link), begun.addSecs(3'600));
        connect();
    }
    void read(Place place, const std::vector<Parameter> &parameters)
    {
        ASSERT_TRUE(at(place).start(ReadParameters{parameters}));
        for (int i = 0; i < 1'000 && at(place).runningJob(); ++i)
            bus.advance(10);
    }
    EncoderSession &at(Place place) { return *bus.encoder(place); }

    static constexpr Place fraba = "1.0"_ring;
    static constexpr Place baumer = "2.0"_ring;

    const Catalog catalog = Catalog::builtIn();
    RingSession bus{std::make_unique<RealLink>(makeTrainingBus(catalog).link), catalog, begun};
    KnownKeeper keeper;
};

TEST_F(KnownKeeperTest, WhatWasReadIsUnknownUntilItIsTheSameEncoder)
{
    read(fraba, {Parameter::steps, Parameter::revolutions});
    ASSERT_EQ(at(fraba).known(Parameter::steps)->value, 8'192);
    reconnect();
    EXPECT_FALSE(at(fraba).known(Parameter::steps));
    ASSERT_TRUE(at(fraba).knownBefore());
    EXPECT_FALSE(at(baumer).knownBefore()) << "nothing was known of it";
    at(fraba).takeKnownBefore();
    const auto steps = at(fraba).known(Parameter::steps);
    ASSERT_TRUE(steps);
    EXPECT_EQ(steps->value, 8'192);
    EXPECT_EQ(steps->evidence, Evidence::read);
    EXPECT_LT(std::abs(begun.secsTo(at(fraba).dateTime(steps->at))), 60) << "as old as it is";
    EXPECT_FALSE(at(fraba).knownBefore()) << "it is settled";
}

TEST_F(KnownKeeperTest, TheSameEncoderHasItsSerialNumberAgain)
{
    read(fraba, {Parameter::steps, Parameter::serialNumber});
    const auto number = at(fraba).known(Parameter::serialNumber);
    ASSERT_TRUE(number);
    reconnect();
    EXPECT_FALSE(at(fraba).known(Parameter::serialNumber));
    at(fraba).takeKnownBefore();
    ASSERT_TRUE(at(fraba).known(Parameter::serialNumber));
    EXPECT_EQ(at(fraba).known(Parameter::serialNumber)->value, number->value);
}

TEST_F(KnownKeeperTest, TheSameSerialNumberSettlesIt)
{
    read(fraba, {Parameter::steps, Parameter::serialNumber});
    reconnect();
    read(fraba, {Parameter::serialNumber});
    EXPECT_EQ(at(fraba).known(Parameter::steps)->value, 8'192);
    EXPECT_FALSE(at(fraba).knownBefore());
}

// Within a second an encoder may have been exchanged, or a PLC may have switched the mode.
TEST_F(KnownKeeperTest, WhatWasReadIsUnknownOnceALostLinkIsBack)
{
    at(fraba).tell(Parameter::startUpMode, 1);
    read(fraba, {Parameter::steps, Parameter::serialNumber});
    ASSERT_EQ(at(fraba).latest().mode, Mode::position);
    loseForAMoment();
    EXPECT_FALSE(at(fraba).known(Parameter::steps));
    EXPECT_FALSE(at(fraba).latest().mode);
    ASSERT_TRUE(at(fraba).knownBefore());
    bus.setOperate(true);
    bus.advance(10);
    read(fraba, {Parameter::serialNumber});
    EXPECT_EQ(at(fraba).known(Parameter::steps)->value, 8'192) << "it is the same one";
    EXPECT_FALSE(at(fraba).latest().mode) << "which may have been switched all the same";
}

TEST_F(KnownKeeperTest, AnotherSerialNumberIsAnotherEncoder)
{
    read(fraba, {Parameter::steps, Parameter::serialNumber});
    KnownBefore other = [&] {
        reconnect();
        return *at(fraba).knownBefore();
    }();
    *other.serialNumber += 1;
    at(fraba).setKnownBefore(other);
    read(fraba, {Parameter::serialNumber});
    EXPECT_FALSE(at(fraba).known(Parameter::steps));
    EXPECT_FALSE(at(fraba).knownBefore());
    reconnect();
    EXPECT_FALSE(at(fraba).known(Parameter::steps)) << "nor the next time";
}

TEST_F(KnownKeeperTest, WhatIsKnownAnewStays)
{
    at(baumer).tell(Parameter::steps, 1'000);
    at(baumer).tell(Parameter::revolutions, 4);
    reconnect();
    at(baumer).tell(Parameter::steps, 2'000);
    at(baumer).takeKnownBefore();
    EXPECT_EQ(at(baumer).known(Parameter::steps)->value, 2'000);
    EXPECT_EQ(at(baumer).known(Parameter::revolutions)->value, 4);
    EXPECT_EQ(at(baumer).known(Parameter::revolutions)->evidence, Evidence::told);
}

TEST_F(KnownKeeperTest, AnOpenQuestionOutlivesAnotherConnection)
{
    at(baumer).tell(Parameter::steps, 1'000);
    reconnect();
    at(baumer).tell(Parameter::revolutions, 4); // the question is still open
    reconnect();
    ASSERT_TRUE(at(baumer).knownBefore());
    EXPECT_EQ(at(baumer).knownBefore()->values.size(), 2u);
}

// The controller may have switched it meanwhile: in cam mode a preset would set a cam.
TEST_F(KnownKeeperTest, TheModeIsUnknownAfterEachConnection)
{
    at(fraba).tell(Parameter::startUpMode, 1);
    at(fraba).tell(Parameter::steps, 8'192);
    bus.advance(10);
    ASSERT_EQ(at(fraba).latest().mode, Mode::position);
    reconnect();
    at(fraba).takeKnownBefore();
    bus.advance(10);
    EXPECT_EQ(at(fraba).known(Parameter::steps)->value, 8'192);
    EXPECT_FALSE(at(fraba).latest().mode);
}

TEST_F(KnownKeeperTest, AnotherKindOfEncoderIsAnotherOne)
{
    at(fraba).tell(Parameter::steps, 8'192);
    reconnect();
    ASSERT_TRUE(bus.name(fraba, QStringLiteral("baumer-gxp6w")));
    bus.advance(10);
    EXPECT_FALSE(at(fraba).knownBefore());
}

TEST_F(KnownKeeperTest, OfAnEncoderThatReplacesAnotherNothingIsKnown)
{
    at(fraba).tell(Parameter::steps, 8'192);
    ASSERT_TRUE(bus.replace(fraba, QStringLiteral("fraba-ocd-ib"), 0, 0));
    bus.advance(10);
    EXPECT_FALSE(at(fraba).known(Parameter::steps));
    EXPECT_FALSE(at(fraba).knownBefore());
    reconnect();
    EXPECT_FALSE(at(fraba).knownBefore());
}

TEST_F(KnownKeeperTest, IsForgottenWithTheLink)
{
    at(baumer).tell(Parameter::steps, 1'000);
    bus.close();
    keeper.forget();
    replaceRing();
    EXPECT_FALSE(at(baumer).knownBefore());
}

class KnownOfSimulated : public KnownKeeperTest
{
protected:
    KnownOfSimulated()
    {
        keeper.watch(ring);
        openRing();
        ring.encoder(baumer)->tell(Parameter::steps, 1'000);
    }
    void openRing() { ASSERT_TRUE(ring.open(RingSession::Start::operating)); }

    RingSession ring{makeTrainingBus(catalog).link, catalog, begun};
};

TEST_F(KnownOfSimulated, IsThatOfTheSameEncoder)
{
    ring.close();
    openRing();
    EXPECT_EQ(ring.encoder(baumer)->known(Parameter::steps)->value, 1'000);
    EXPECT_FALSE(ring.encoder(baumer)->knownBefore());
}

// Another project may be open by then: they are the same all the same.
TEST_F(KnownOfSimulated, StaysUntilItIsMadeAnew)
{
    auto before = ring.useLink(std::make_unique<RealLink>(makeTrainingBus(catalog).link), begun);
    keeper.forget();
    ring.useLink(std::move(before), begun);
    openRing();
    EXPECT_EQ(ring.encoder(baumer)->known(Parameter::steps)->value, 1'000);
    ring.close();
    keeper.forgetSimulated();
    openRing();
    EXPECT_FALSE(ring.encoder(baumer)->known(Parameter::steps));
}

// What holds for simulated encoders does not for real ones at the same places.
TEST_F(KnownOfSimulated, IsNotOfferedForARealOne)
{
    ring.useLink(std::make_unique<RealLink>(makeTrainingBus(catalog).link), begun);
    openRing();
    EXPECT_FALSE(ring.encoder(baumer)->knownBefore());
    EXPECT_FALSE(ring.encoder(baumer)->known(Parameter::steps));
}

// What was written by the place alone, without the serial number having been read.
class LedgerAfterLossTest : public KnownKeeperTest
{
protected:
    LedgerAfterLossTest()
    {
        at(fraba).tell(Parameter::startUpMode, 1);
        write();
        EXPECT_EQ(at(fraba).eepromCount().writes, 1);
    }
    void write()
    {
        EXPECT_TRUE(at(fraba).start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
        for (int i = 0; i < 1'000 && at(fraba).runningJob(); ++i)
            bus.advance(10);
    }
    int writesOfReadNumber()
    {
        bus.setOperate(true);
        bus.advance(10);
        read(fraba, {Parameter::serialNumber});
        EXPECT_EQ(at(fraba).eepromCount().by, CountedBy::serialNumber);
        return at(fraba).eepromCount().writes;
    }

    LedgerKeeper ledger{bus, DatabasePlace::memory()};
};

TEST_F(LedgerAfterLossTest, TheNumberOfWhoeverIsThereThenGetsNothingWhileNobodyHasSaidThatItIsTheSame)
{
    loseForAMoment();
    ASSERT_TRUE(at(fraba).knownBefore());
    EXPECT_EQ(writesOfReadNumber(), 0);
    EXPECT_EQ(at(fraba).eepromCount().atPlace, 1) << "perhaps";
}

TEST_F(LedgerAfterLossTest, NorDoesAnotherOne)
{
    loseForAMoment();
    at(fraba).setKnownBefore({});
    EXPECT_EQ(writesOfReadNumber(), 0);
    EXPECT_EQ(at(fraba).eepromCount().atMost(), 1);
}

// What was counted by the place is that of the one before.
TEST_F(LedgerAfterLossTest, TheCountOfAnotherOneIsInDoubtAtOnce)
{
    loseForAMoment();
    EXPECT_EQ(at(fraba).eepromCount().writes, 1);
    at(fraba).setKnownBefore({});
    EXPECT_EQ(at(fraba).eepromCount().by, CountedBy::place);
    EXPECT_EQ(at(fraba).eepromCount().writes, 0);
    EXPECT_EQ(at(fraba).eepromCount().atPlace, 1);
    bus.setOperate(true);
    bus.advance(10);
    at(fraba).tell(Parameter::startUpMode, 1);
    write();
    EXPECT_EQ(at(fraba).eepromCount().writes, 1);
    EXPECT_EQ(at(fraba).eepromCount().atPlace, 1);
}

// Its label is still to be typed.
TEST_F(LedgerAfterLossTest, AnotherOneIsNotCountedByTheLabelOfTheOneBefore)
{
    const QString label = QStringLiteral("4711");
    ledger.setLabel(fraba, label);
    EXPECT_EQ(at(fraba).eepromCount().writes, 1);
    loseForAMoment();
    at(fraba).setKnownBefore({});
    ledger.setLabel(fraba, label); // something else of the project was changed
    EXPECT_EQ(at(fraba).eepromCount().by, CountedBy::place);
    EXPECT_EQ(at(fraba).eepromCount().writes, 0);
    ledger.setLabel(fraba, QStringLiteral("4712"));
    EXPECT_EQ(at(fraba).eepromCount().by, CountedBy::labelSerialNumber);
    EXPECT_EQ(at(fraba).eepromCount().writes, 0);
}

TEST_F(LedgerAfterLossTest, TheSameOneGetsItsWrites)
{
    loseForAMoment();
    at(fraba).takeKnownBefore();
    EXPECT_EQ(writesOfReadNumber(), 1);
    EXPECT_EQ(at(fraba).eepromCount().atPlace, 0);
}

// As encoders have that were given none, and those of a served project without labels.
TEST(SerialNumberZero, IdentifiesNobody)
{
    const Catalog catalog = Catalog::builtIn();
    TrainingPlan plan = trainingPlan(catalog);
    plan.front().serialNumber = 0;
    RingSession bus{std::make_unique<RealLink>(makeTrainingBus(plan).link), catalog, begun};
    ASSERT_TRUE(bus.open(RingSession::Start::operating));
    bus.advance(10);
    LedgerKeeper ledger{bus, DatabasePlace::memory()};
    EncoderSession &encoder = *bus.encoder("1.0"_ring);
    ASSERT_TRUE(encoder.start(ReadParameters{{Parameter::serialNumber}}));
    for (int i = 0; i < 1'000 && encoder.runningJob(); ++i)
        bus.advance(10);
    ASSERT_EQ(encoder.known(Parameter::serialNumber)->value, 0);
    EXPECT_EQ(encoder.eepromCount().by, CountedBy::place);
    EXPECT_FALSE(reportedSerialNumber(encoder));
}

} // namespace
} // namespace codewheel
