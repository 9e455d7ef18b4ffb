// SPDX-License-Identifier: GPL-3.0-or-later
// Whose dial is shown: a pinned one stays while others are chosen.
#include "tests/widgets/training_bus_session.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/dial/dial_pin.h"
#include "widgets/monitor/meaning_line.h"

#include <QCoreApplication>
#include <QLabel>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class DialPinTest : public testing::Test
{
protected:
    DialPinTest()
    {
        panel.resize(280, 360);
        panel.show();
        choose(fraba);
    }

    void choose(Place place) { dial.follow(ring.buses.encoder(place)); }
    QToolButton &button() { return *panel.findChild<QToolButton *>(QStringLiteral("pinDial")); }
    void press()
    {
        QCoreApplication::processEvents();
        QTest::mouseClick(&button(), Qt::LeftButton);
    }
    QString title() { return panel.findChild<MeaningLine *>(QStringLiteral("dialTitle"))->text(); }
    QString shownPlace() // of the disc, to a screen reader
    {
        const auto *disc = panel.findChild<CodeDisc *>();
        return disc->isVisible() ? disc->accessibleName() : QString();
    }
    bool says(const QString &text)
    {
        const auto labels = panel.findChildren<QLabel *>();
        return std::ranges::any_of(
            labels, [&](const QLabel *label) { return label->isVisible() && label->text() == text; });
    }

    test::TrainingBusSession ring;
    QString station;
    DialPanel panel;
    DialPin &dial = *new DialPin(panel, ring.buses,
                                 [this](Place place) { return place == baumer ? station : QString(); });
};

TEST_F(DialPinTest, FollowsTheChoiceAndSaysWhoseItIs)
{
    EXPECT_EQ(title(), QStringLiteral("1.0  FRABA OCD-IB K3"));
    EXPECT_FALSE(button().isChecked());
    choose(baumer);
    EXPECT_EQ(title(), QStringLiteral("2.0  Baumer GXP6W K3"));
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 2.0"));
    station = QStringLiteral("Hoist");
    dial.showHead();
    EXPECT_EQ(title(), QStringLiteral("2.0  Hoist  Baumer GXP6W K3"));
}

TEST_F(DialPinTest, APinnedOneStaysWhileOthersAreChosenUntilItIsUnpinned)
{
    choose(baumer);
    press();
    EXPECT_TRUE(button().isChecked());
    EXPECT_EQ(button().toolButtonStyle(), Qt::ToolButtonTextBesideIcon) << "it says that it is pinned";
    EXPECT_EQ(dial.toKeep(), baumer);
    choose(fraba);
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 2.0"));
    EXPECT_EQ(title(), QStringLiteral("2.0  Baumer GXP6W K3"));
    press();
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 1.0"));
    EXPECT_EQ(title(), QStringLiteral("1.0  FRABA OCD-IB K3"));
    EXPECT_EQ(dial.toKeep(), std::nullopt);
}

TEST_F(DialPinTest, OfNobodyCannotBePinned)
{
    choose(test::busTerminal);
    EXPECT_FALSE(button().isEnabled());
    EXPECT_EQ(shownPlace(), QString());
}

TEST_F(DialPinTest, WhileItsBusIsClosedItSaysSoAndComesBackWithIt)
{
    choose(baumer);
    press();
    choose(fraba);
    ring.bus.close();
    EXPECT_TRUE(says(QStringLiteral("2.0 is not connected")));
    EXPECT_EQ(title(), QStringLiteral("2.0"));
    EXPECT_TRUE(button().isChecked()) << "and can be unpinned";
    ASSERT_TRUE(ring.bus.open(RingSession::Start::watching));
    ring.bus.advance(10);
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 2.0"));
}

TEST_F(DialPinTest, OneThatIsOnlyPlannedOnAConnectedBusIsNotThere)
{
    const Place planned = "9.0"_ring;
    dial.follow({planned, ring.encoder(fraba).device()});
    EXPECT_TRUE(says(QStringLiteral("There is no encoder at 9.0")));
    EXPECT_FALSE(says(QStringLiteral("9.0 is not connected")));
    ring.bus.close();
    EXPECT_TRUE(says(QStringLiteral("9.0 is not connected")));
}

TEST_F(DialPinTest, WhereAnotherDeviceStandsItSaysSo)
{
    dial.restore(test::busTerminal);
    EXPECT_TRUE(says(QStringLiteral("There is no encoder at 6.0")));
    press();
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 1.0"));
}

TEST_F(DialPinTest, OneThatTheUserDidNotPinGoesWithItsBusAndIsNotKept)
{
    dial.pinForNow(baumer);
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 2.0"));
    EXPECT_EQ(dial.toKeep(), std::nullopt);
    ring.bus.close();
    EXPECT_FALSE(button().isChecked());
    ASSERT_TRUE(ring.bus.open(RingSession::Start::watching));
    ring.bus.advance(10);
    choose(fraba);
    EXPECT_EQ(shownPlace(), QStringLiteral("Dial of 1.0"));
}

} // namespace
} // namespace codewheel
