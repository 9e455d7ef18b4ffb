// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/profiles.h"
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class OtherRingTest : public test::WindowTest
{
protected:
    void cause(TrainingFault fault, Place place, int value = 1)
    {
        shown->controls().setFault(fault, place.node, value);
        advance(60);
    }
};

TEST_F(OtherRingTest, TheWindowFollowsTheRingThatWasReadIn)
{
    monitors().closeAll();
    monitors().pin(fraba);
    monitors().pin("6.1"_ring);
    window().findChild<StructureView *>()->choose("6.1"_ring);
    cause(TrainingFault::wireBreak, "6.0"_ring);
    ringActions().readIn->trigger();
    advance(100);
    EXPECT_TRUE(bus().isRunning());
    EXPECT_EQ(bus().structure().size(), 5U);
    ASSERT_EQ(monitors().cards().size(), 1U);
    EXPECT_EQ(monitors().cards().front()->place(), fraba);
    EXPECT_EQ(window().findChild<StructureView *>()->current(), fraba);
    advance(200);

    cause(TrainingFault::wireBreak, "6.0"_ring, 0);
    ringActions().readIn->trigger();
    advance(100);
    EXPECT_EQ(bus().structure().size(), 7U);
    EXPECT_TRUE(bus().isRunning());
}

TEST_F(OtherRingTest, TheChosenEncoderAndItsMonitorsStay)
{
    WordCard *monitor = monitors().cards().front();
    cause(TrainingFault::wrongDevice, baumer);
    ringActions().readIn->trigger();
    advance(100);
    EXPECT_EQ(monitors().cards().front(), monitor);
    EXPECT_EQ(window().findChild<StructureView *>()->current(), fraba);
    EXPECT_EQ(bus().encoder(baumer)->device().profile, profile::k2);
    window().findChild<StructureView *>()->choose(baumer);
    advance(100);
}

TEST_F(OtherRingTest, ASegmentIsSwitchedByItsAction)
{
    window().findChild<StructureView *>()->choose("6.1"_ring);
    ringActions().switchSegment->trigger();
    advance(10);
    EXPECT_TRUE(bus().latest().devices[6].inRing) << "it is asked for";
    auto *question = window().findChild<InlineMessage *>(QStringLiteral("masterMessage"));
    ASSERT_TRUE(question->isVisible()) << "the panel was brought to the front";
    QTest::mouseClick(question->findChild<QPushButton *>(), Qt::LeftButton);
    advance(10);
    EXPECT_FALSE(bus().latest().devices[6].inRing);
    ringActions().switchSegment->trigger();
    advance(10);
    EXPECT_TRUE(bus().latest().devices[6].inRing);
}

TEST_F(OtherRingTest, OnlyTheSegmentOfAChosenDeviceOfTheRingIsSwitched)
{
    const QAction &action = *ringActions().switchSegment;
    EXPECT_TRUE(action.isEnabled());
    window().findChild<StructureView *>()->choose(placeOnLine({0x05}));
    EXPECT_FALSE(action.isEnabled());
    EXPECT_TRUE(action.toolTip().startsWith(QStringLiteral("No device with a segment"))) << "it says why";
    window().findChild<StructureView *>()->choose(baumer);
    EXPECT_TRUE(action.isEnabled());
    ringActions().disconnectBus->trigger();
    EXPECT_FALSE(action.isEnabled());
    EXPECT_TRUE(action.toolTip().startsWith(QStringLiteral("The ring is not connected")));
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_TRUE(action.isEnabled());
}

TEST_F(OtherRingTest, InWatchNeitherIsReadInNorConfirmed)
{
    actions().watch->trigger();
    advance(10);
    const auto *notice = window().findChild<InlineMessage *>(QStringLiteral("notice"));
    for (QAction *action : {ringActions().readIn, ringActions().confirmDiagnostics}) {
        action->trigger();
        advance(50);
        EXPECT_TRUE(notice->isVisible());
        EXPECT_TRUE(notice->sentence().contains(QStringLiteral("Switch to Operate first")));
        EXPECT_TRUE(bus().isRunning());
    }
    actions().stop->trigger();
    advance(10);
    EXPECT_FALSE(bus().isRunning()) << "that is always possible";
    actions().operate->trigger();
    advance(10);
    EXPECT_FALSE(notice->isVisible());
}

} // namespace
} // namespace codewheel
