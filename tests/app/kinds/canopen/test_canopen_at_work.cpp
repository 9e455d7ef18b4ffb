// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/kinds/canopen/canopen_window_test.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::nodeFive;
using test::nodeSeven;
using test::nodeSix;

const QString atInterface = QStringLiteral("can:can0");

KindData canPlanOf(const CanopenSettings &settings)
{
    return KindData(CanopenPlan{settings});
}

class CanopenAtWorkTest : public test::CanopenWindowTest
{};

TEST_F(CanopenAtWorkTest, TheTrainingPlantGoesWithoutItUntilItIsAskedFor)
{
    EXPECT_EQ(canBus().session(), nullptr);
    EXPECT_FALSE(tree().has(nodeFive));
    canBus().connectTraining();
    advance(1'000);
    ASSERT_TRUE(canBus().isOpen());
    EXPECT_TRUE(session().isOperating());
    EXPECT_TRUE(session().isSimulated());
    EXPECT_EQ(session().encoder(nodeFive)->device().key, QStringLiteral("canopen-406-single-turn"));
    EXPECT_EQ(session().encoder(nodeSix)->device().key, QStringLiteral("canopen-406-multi-turn"));
    EXPECT_EQ(session().encoder(nodeSeven)->device().key, QStringLiteral("canopen-406-linear"));
    for (const Place place : {nodeFive, nodeSix, nodeSeven}) {
        EXPECT_TRUE(tree().has(place));
        EXPECT_TRUE(session().encoder(place)->latest().position) << place.toString().toStdString();
    }
}

TEST_F(CanopenAtWorkTest, ItBeginsAnewInTheModeItWasIn)
{
    canBus().connectTraining();
    session().setOperate(false);
    advance(200);
    ASSERT_FALSE(session().isOperating());
    canBus().startAfresh();
    advance(200);
    EXPECT_FALSE(session().isOperating());
    EXPECT_EQ(session().places().size(), 3U);
}

TEST_F(CanopenAtWorkTest, TheWindowGoesOnWhileAnAdapterIsOpened)
{
    plan(atInterface, {nodeFive, nodeSix});
    bench.mayOpen.acquire(1'000);
    canBus().open(canPlanOf({.link = atInterface, .rate = 125'000}));
    advance(500);
    EXPECT_TRUE(canBus().isOpening());
    EXPECT_EQ(canBus().session(), nullptr);
    bench.mayOpen.release(1'000);
    ASSERT_TRUE(hasOpened());
    EXPECT_EQ(session().places(), (std::vector{nodeFive, nodeSix}));
    EXPECT_FALSE(session().isOperating());
    EXPECT_TRUE(comes([this] {
        return session().encoder(nodeSix)->latest().position.has_value() ||
               session().latest().heard(6) != nullptr;
    }));
    EXPECT_EQ(bench.sent, 0); // Watch
}

TEST_F(CanopenAtWorkTest, WhatIsRefusedLeavesTheBusThatIsOpen)
{
    canBus().connectTraining();
    bench.isMissing = true;
    std::vector<Refusal> refused;
    QObject::connect(&canBus(), &CanopenAtWork::openRefused, &window(),
                     [&](const Refusal &why) { refused.push_back(why); });
    canBus().open(canPlanOf({.link = atInterface, .rate = 125'000}));
    ASSERT_TRUE(comes([&] { return !refused.empty(); }));
    EXPECT_EQ(refused.front().id, CanRefusalId::interfaceMissing);
    EXPECT_TRUE(canBus().isOpen());
    EXPECT_NE(canBus().training(), nullptr);
    canBus().open(canPlanOf({.link = QStringLiteral("gone:x"), .rate = 125'000}));
    EXPECT_EQ(refused.back().id, CanRefusalId::linkNotUnderstood);
}

TEST_F(CanopenAtWorkTest, WithoutAPromiseToListenOnlyItIsOpenedOnceTheUserAgrees)
{
    bench.listensOnly = false;
    std::vector<Refusal> refused;
    QObject::connect(&canBus(), &CanopenAtWork::openRefused, &window(),
                     [&](const Refusal &why) { refused.push_back(why); });
    const KindData unsure = canPlanOf({.link = atInterface, .rate = 125'000});
    canBus().open(unsure);
    ASSERT_TRUE(comes([&] { return !refused.empty(); }));
    EXPECT_EQ(refused.front().id, CanRefusalId::watchNotSure);
    canBus().openAgreed(unsure);
    ASSERT_TRUE(hasOpened());
    EXPECT_EQ(canBus().openedWith(), unsure);
}

TEST_F(CanopenAtWorkTest, TheSimulatedEncodersGiveWayToTheBusOfAProject)
{
    canBus().connectTraining();
    plan(atInterface, {nodeFive});
    EXPECT_FALSE(canBus().isOpen());
    EXPECT_TRUE(tree().has(nodeFive)); // as planned
    EXPECT_FALSE(tree().has(nodeSix));
    shown->project().setProject({}, {});
    EXPECT_TRUE(canBus().isOpen());
}

} // namespace
} // namespace codewheel
