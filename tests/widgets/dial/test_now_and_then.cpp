// SPDX-License-Identifier: GPL-3.0-or-later
// The dial before a position is set: now, as the shaft moves, and what will be shown.
#include "tests/widgets/rod_bus.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/now_and_then.h"
#include "widgets/dial/rod_view.h"

#include <QAccessible>
#include <QImage>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::rodPlace;

class NowAndThenTest : public testing::Test
{
protected:
    explicit NowAndThenTest(TrainingBus (*make)(const Catalog &) = makeTrainingBus)
        : ring(RingSession::Start::operating, make)
    {
        picture.resize(240, 320);
        picture.show();
    }

    const DialState &shaft() { return picture.findChild<CodeDisc *>()->state(); }
    const RodState &rod() { return picture.findChild<RodView *>()->state(); }
    static QString said(const QWidget &view)
    {
        return QAccessible::queryAccessibleInterface(const_cast<QWidget *>(&view))
            ->text(QAccessible::Description);
    }
    void advance(int milliseconds)
    {
        for (; milliseconds > 0; milliseconds -= 33)
            ring.bus.advance(33);
    }
    // With 8192 steps per turn, clockwise.
    EncoderSession &frabaThatIsKnown()
    {
        EncoderSession &encoder = ring.encoder(fraba);
        encoder.tell(Parameter::startUpMode, 1);
        encoder.tell(Parameter::steps, 8192);
        encoder.tell(Parameter::revolutions, 1);
        encoder.tell(Parameter::direction, 3);
        advance(66);
        return encoder;
    }
    EncoderSession &baumerThatIsKnown()
    {
        EncoderSession &encoder = ring.encoder(baumer);
        encoder.tell(Parameter::coding, 3);
        encoder.tell(Parameter::steps, 8192);
        encoder.tell(Parameter::revolutions, 1);
        encoder.tell(Parameter::measuringRange, 4096);
        advance(66);
        return encoder;
    }
    void byPreset(EncoderSession &encoder)
    {
        picture.setEncoder(encoder);
        picture.setThenByPreset([&encoder](Parameter parameter) { return knownNumber(encoder, parameter); });
    }

    test::TrainingBusSession ring;
    NowAndThen picture;
};

TEST_F(NowAndThenTest, NowFollowsTheShaftAndThenStays)
{
    ring.controls->turnTo(fraba.node, 2'048);
    picture.setEncoder(frabaThatIsKnown());
    picture.setThen(4'096);
    EXPECT_EQ(shaft().position, 2'048);
    EXPECT_EQ(shaft().turnFraction, 0.25);
    ASSERT_TRUE(shaft().then);
    EXPECT_EQ(shaft().then->position, 4'096);
    EXPECT_EQ(shaft().then->turnFraction, 0.5);
    ring.controls->turnBy(fraba.node, 1'024);
    advance(66);
    EXPECT_EQ(shaft().position, 3'072);
    EXPECT_EQ(shaft().turnFraction, 0.375);
    EXPECT_EQ(shaft().then->turnFraction, 0.5);
    EXPECT_EQ(ring.channel(fraba).out(), 0u) << "looking sends nothing";
}

TEST_F(NowAndThenTest, BothAreSaidWithTheirNumbers)
{
    ring.controls->turnTo(fraba.node, 2'048);
    picture.setEncoder(frabaThatIsKnown());
    picture.setThen(4'096);
    const QString text = said(*picture.findChild<CodeDisc *>());
    EXPECT_TRUE(text.contains(QStringLiteral("Position 2048"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("then 4096"))) << text.toStdString();
}

TEST_F(NowAndThenTest, TheSecondPointerIsPaintedWhereTheShaftWillBe)
{
    ring.controls->turnTo(fraba.node, 0);
    auto *disc = picture.findChild<CodeDisc *>();
    const auto paintedThen = [&](std::optional<std::int64_t> then) {
        picture.setThen(then);
        return disc->grab().toImage();
    };
    picture.setEncoder(frabaThatIsKnown());
    const QImage without = paintedThen(std::nullopt);
    const QImage with = paintedThen(2'048); // a quarter to the right
    const auto differs = [&](const QRect &where) { return without.copy(where) != with.copy(where); };
    const int middle = disc->width() / 2;
    const int quarter = disc->width() / 4;
    EXPECT_TRUE(differs(QRect(middle + quarter, quarter, quarter, 2 * quarter)));
    EXPECT_FALSE(differs(QRect(0, quarter, quarter, 2 * quarter)));
}

TEST_F(NowAndThenTest, APresetIsCountedWithItsOffset)
{
    EncoderSession &encoder = baumerThatIsKnown();
    encoder.tell(Parameter::preset, 1'000);
    encoder.tell(Parameter::offset, 24);
    byPreset(encoder);
    ASSERT_TRUE(shaft().then);
    EXPECT_EQ(shaft().then->position, 1'024);
    EXPECT_EQ(shaft().then->turnFraction, 0.125);
    EXPECT_FALSE(shaft().note.contains(QStringLiteral("not known")));
}

TEST_F(NowAndThenTest, WithoutTheOffsetOnlyNowIsDrawnAndItSaysWhy)
{
    EncoderSession &encoder = baumerThatIsKnown();
    encoder.tell(Parameter::preset, 1'000);
    byPreset(encoder);
    EXPECT_TRUE(shaft().turnFraction);
    ASSERT_TRUE(shaft().then);
    EXPECT_EQ(shaft().then->position, std::nullopt);
    EXPECT_EQ(shaft().then->turnFraction, std::nullopt);
    EXPECT_TRUE(
        shaft().note.startsWith(QStringLiteral("What it will show then is not known. Missing: Offset.")))
        << shaft().note.toStdString();
    EXPECT_TRUE(said(*picture.findChild<CodeDisc *>()).contains(QStringLiteral("then: not known")));
}

// Both numbers, though the disc cannot turn.
TEST_F(NowAndThenTest, WithoutTheScaleThereAreOnlyNumbers)
{
    EncoderSession &encoder = ring.encoder(fraba);
    encoder.tell(Parameter::startUpMode, 1);
    advance(66);
    picture.setEncoder(encoder);
    picture.setThen(500);
    EXPECT_EQ(shaft().position, 12'345);
    EXPECT_EQ(shaft().turnFraction, std::nullopt);
    EXPECT_EQ(shaft().then, (DialState::Then{500, std::nullopt}));
}

TEST_F(NowAndThenTest, AnotherScaleMayCountThen)
{
    picture.setEncoder(frabaThatIsKnown());
    EncoderSession &encoder = ring.encoder(fraba);
    picture.setThen(100, {}, [&encoder](Parameter its) {
        return its == Parameter::steps ? std::optional<std::int64_t>(400) : knownNumber(encoder, its);
    });
    EXPECT_EQ(shaft().then->turnFraction, 0.25);
}

class RodNowAndThen : public NowAndThenTest
{
protected:
    RodNowAndThen()
        : NowAndThenTest(test::makeRodBus)
    {
        ring.controls->moveMagnetTo(rodPlace.node, 125);
        EXPECT_TRUE(
            encoder().start(ReadParameters{{Parameter::direction, Parameter::measuringLength}}).has_value());
        advance(1'000);
        encoder().tell(Parameter::rodLength, 500'000);
        picture.setEncoder(encoder());
    }
    EncoderSession &encoder() { return ring.encoder(rodPlace); }
};

TEST_F(RodNowAndThen, ASecondMagnetStandsWhereTheRodWillCount)
{
    const std::int64_t length = encoder().known(Parameter::measuringLength)->value.number();
    picture.setThen(length / 2);
    EXPECT_TRUE(picture.findChild<RodView *>()->isVisible());
    EXPECT_FALSE(picture.findChild<CodeDisc *>()->isVisible());
    EXPECT_NEAR(magnetPlace(rod()).value_or(-1), 0.25, 0.01);
    EXPECT_NEAR(magnetPlaceThen(rod()).value_or(-1), 0.5, 0.01);
    ring.controls->moveMagnetTo(rodPlace.node, 250);
    advance(500);
    EXPECT_NEAR(magnetPlace(rod()).value_or(-1), 0.5, 0.01);
    EXPECT_NEAR(magnetPlaceThen(rod()).value_or(-1), 0.5, 0.01);
    const QString text = said(*picture.findChild<RodView *>());
    EXPECT_TRUE(text.contains(QStringLiteral("then %1 (250.").arg(length / 2))) << text.toStdString();
}

TEST_F(RodNowAndThen, BeyondTheMeasuringLengthThereIsOnlyTheNumber)
{
    picture.setThen(encoder().known(Parameter::measuringLength)->value.number() + 1);
    EXPECT_TRUE(magnetPlace(rod()));
    EXPECT_FALSE(magnetPlaceThen(rod()));
    EXPECT_TRUE(rod().then && rod().then->position);
}

TEST_F(RodNowAndThen, TheSecondMagnetIsPainted)
{
    auto *view = picture.findChild<RodView *>();
    picture.setThen(std::nullopt);
    const QRect right(view->width() * 3 / 4, 0, view->width() / 4, view->height() / 2);
    const QImage without = view->grab(right).toImage();
    picture.setThen(encoder().known(Parameter::measuringLength)->value.number());
    EXPECT_NE(view->grab(right).toImage(), without);
}

TEST_F(RodNowAndThen, AnotherMeasuringLengthMayCountThen)
{
    const auto valueThen = [this](Parameter its) {
        return its == Parameter::measuringLength ? std::optional<std::int64_t>(5'000)
                                                 : knownNumber(encoder(), its);
    };
    picture.setThen(1'000, {}, valueThen);
    EXPECT_NEAR(magnetPlace(rod()).value_or(-1), 0.25, 0.01);
    EXPECT_NEAR(magnetPlaceThen(rod()).value_or(-1), 0.2, 0.01);
    const QString text = said(*picture.findChild<RodView *>());
    EXPECT_TRUE(text.contains(QStringLiteral("then 1000 (100."))) << text.toStdString();
}

} // namespace
} // namespace codewheel
