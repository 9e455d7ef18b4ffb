// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"
#include "widgets/look/appearance.h"
#include "widgets/monitor/word_view.h"

#include <QApplication>
#include <QCoreApplication>
#include <QEvent>
#include <QHelpEvent>
#include <QImage>
#include <QLineEdit>
#include <QPaintEvent>
#include <QPoint>
#include <QRegion>
#include <QSignalSpy>
#include <QSize>
#include <QStatusTipEvent>
#include <QTest>
#include <QToolTip>
#include <QVariant>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class WordViewTest : public testing::Test
{
protected:
    WordViewTest()
    {
        window.resize(1400, 200);
        view.setPlace(QStringLiteral("OUT 1.0"));
        view.setEditable(true);
        window.show();
        window.activateWindow();
        view.setFocus();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    ~WordViewTest() override { applyAppearance(*qApp, {.scheme = Scheme::light}); }

    void click(int bit) { QTest::mouseClick(&view, Qt::LeftButton, {}, view.bitRect(bit).center()); }
    QList<int> toggledBits() const
    {
        QList<int> bits;
        for (const QList<QVariant> &signal : toggled)
            bits.append(signal.first().toInt());
        return bits;
    }
    QImage picture(int bit) { return view.grab(view.bitRect(bit)).toImage(); }

    const DeviceDescription k3;
    QWidget window;
    WordView view{wordForm(MonitorKind::in32, &k3), &window};
    QSignalSpy toggled{&view, &WordView::bitToggled};
};

TEST_F(WordViewTest, AClickAsksForItsBitAndChangesNothingItself)
{
    for (const int bit : {31, 25, 24, 16, 0})
        click(bit);
    EXPECT_EQ(toggledBits(), (QList{31, 25, 24, 16, 0}));
    EXPECT_EQ(view.word(), 0U);
}

TEST_F(WordViewTest, ANumberAboveIsPartOfItsBit)
{
    QTest::mouseClick(&view, Qt::LeftButton, {},
                      view.bitRect(7).center() - QPoint(0, view.bitRect(7).height() / 2 + 4));
    EXPECT_EQ(toggledBits(), QList{7});
}

TEST_F(WordViewTest, ReleasedOverAnotherBitNothingIsAsked)
{
    QTest::mousePress(&view, Qt::LeftButton, {}, view.bitRect(7).center());
    QTest::mouseRelease(&view, Qt::LeftButton, {}, view.bitRect(6).center());
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, TheGapBetweenGroupsIsNoBit)
{
    QTest::mouseClick(&view, Qt::LeftButton, {},
                      QPoint(view.bitRect(28).left() - 4, view.bitRect(28).center().y()));
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, InputWordsDoNotToggle)
{
    view.setEditable(false);
    click(3);
    QTest::keyClick(&view, Qt::Key_Space);
    EXPECT_TRUE(toggled.isEmpty());
    EXPECT_EQ(view.focusedBit(), 3);
}

struct KeyStep
{
    int from;
    Qt::Key key;
    int to;
};

TEST_F(WordViewTest, ArrowsHomeAndEndMoveTheFocusedBit)
{
    for (const KeyStep &step : {KeyStep{31, Qt::Key_Right, 30},
                                {30, Qt::Key_Left, 31},
                                {31, Qt::Key_Left, 31},
                                {0, Qt::Key_Right, 0},
                                {25, Qt::Key_Right, 24},
                                {12, Qt::Key_Home, 31},
                                {12, Qt::Key_End, 0},
                                {12, Qt::Key_Up, 12},
                                {12, Qt::Key_Down, 12}}) {
        view.setFocusedBit(step.from);
        QTest::keyClick(&view, step.key);
        EXPECT_EQ(view.focusedBit(), step.to) << "from " << step.from << " by key " << step.key;
    }
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, InTwoRowsUpAndDownGoToTheBitAboveAndBelow)
{
    window.resize(1024, 200);
    view.setFocusedBit(12);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.focusedBit(), 28);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.focusedBit(), 28);
    QTest::keyClick(&view, Qt::Key_Down);
    EXPECT_EQ(view.focusedBit(), 12);
}

TEST_F(WordViewTest, SpaceTogglesTheFocusedBit)
{
    QTest::keyClick(&view, Qt::Key_End);
    QTest::keyClick(&view, Qt::Key_Left);
    QTest::keyClick(&view, Qt::Key_Space);
    EXPECT_EQ(toggledBits(), QList{1});
}

TEST_F(WordViewTest, TabLeavesTheWord)
{
    QLineEdit next(&window);
    next.show();
    QTest::keyClick(&view, Qt::Key_Tab);
    EXPECT_TRUE(next.hasFocus());
}

TEST_F(WordViewTest, ADisabledWordDoesNothing)
{
    view.setEnabled(false);
    click(3);
    view.toggleBit(3);
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, HalfAnEditedWordIsMarkedAsNotSent)
{
    view.setWord(0x0200'00FF, 0x0000'00FF, 0, 0ms);
    EXPECT_TRUE(view.isStaged(25));
    EXPECT_FALSE(view.isStaged(0));
    const QImage staged = picture(25);
    view.setWord(0x0200'00FF, 0x0200'00FF, 0, 0ms);
    EXPECT_NE(picture(25), staged);
}

TEST_F(WordViewTest, AChangedBitIsMarkedForHalfASecondEvenIfItChangedBack)
{
    view.setWord(0, 0, 0, 900ms);
    const QImage quiet = picture(4);
    view.setWord(0, 0, 0x10, 1000ms);
    EXPECT_NE(picture(4), quiet);
    view.setWord(0, 0, 0, 1499ms);
    EXPECT_TRUE(view.isMarked(4));
    view.setWord(0, 0, 0, 1500ms);
    EXPECT_FALSE(view.isMarked(4));
    EXPECT_EQ(picture(4), quiet);
}

TEST_F(WordViewTest, AMarkDoesNotOutliveItsBus)
{
    view.setWord(0, 0, 0x10, 60s);
    view.setWord(0, 0, 0, 0ms);
    EXPECT_FALSE(view.isMarked(4));
}

TEST_F(WordViewTest, StandsInTwoRowsInANarrowWindowAndInOneInAWideOne)
{
    window.resize(1280, 200);
    EXPECT_EQ(view.bitRect(31).top(), view.bitRect(0).top());
    EXPECT_LE(view.sizeHint().width(), 800);
    window.resize(1279, 200);
    EXPECT_LT(view.bitRect(31).top(), view.bitRect(15).top());
    EXPECT_EQ(view.bitRect(19).left(), view.bitRect(3).left());
    window.resize(1280, 200);
    EXPECT_EQ(view.bitRect(31).top(), view.bitRect(0).top());
}

TEST_F(WordViewTest, GroupsStandApartByEightPixels)
{
    for (const int first : {28, 24, 23, 19, 15, 11, 7, 3})
        EXPECT_EQ(view.bitRect(first).left() - view.bitRect(first + 1).right() - 1, 8)
            << "before bit " << first;
    for (const int inside : {30, 29, 27, 26, 25, 22, 0})
        EXPECT_EQ(view.bitRect(inside).left(), view.bitRect(inside + 1).right() + 1)
            << "before bit " << inside;
}

// TR manual 2.2: status D31..D28, service number D27..D24, data D23..D0.
TEST_F(WordViewTest, GroupsAreThoseOfTheDevice)
{
    DeviceDescription rod;
    rod.profile = Profile::la66;
    const WordView ofRod(wordForm(MonitorKind::in32, &rod), &window);
    const auto gapBefore = [&ofRod](int bit) {
        return ofRod.bitRect(bit).left() - ofRod.bitRect(bit + 1).right() - 1;
    };
    for (const int bit : {27, 23, 19, 15, 11, 7, 3})
        EXPECT_EQ(gapBefore(bit), 8) << "before bit " << bit;
    for (const int bit : {30, 29, 28, 26, 25, 24, 22, 0})
        EXPECT_EQ(gapBefore(bit), 0) << "before bit " << bit;
}

TEST_F(WordViewTest, LargeControlsMakeCellsOneAndAHalfTimesAsLarge)
{
    EXPECT_EQ(view.bitRect(0).size(), QSize(22, 26));
    applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = true});
    QCoreApplication::processEvents();
    EXPECT_EQ(view.bitRect(0).size(), QSize(33, 39));
}

class StatusTips : public QObject
{
public:
    QString last;
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::StatusTip)
            last = static_cast<QStatusTipEvent *>(event)->tip();
        return false;
    }
};

TEST_F(WordViewTest, HoverAndFocusTellWhatTheBitMeans)
{
    StatusTips tips;
    window.installEventFilter(&tips);
    view.setBitText([](int bit) { return bit == 31 ? QStringLiteral("Start") : QString(); });
    QTest::mouseMove(&view, view.bitRect(31).center());
    EXPECT_EQ(tips.last, QStringLiteral("OUT 1.0 bit 31: Start"));
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(tips.last, QStringLiteral("OUT 1.0 bit 30"));

    const QPoint point = view.bitRect(31).center();
    QHelpEvent help(QEvent::ToolTip, point, view.mapToGlobal(point));
    QCoreApplication::sendEvent(&view, &help);
    EXPECT_EQ(QToolTip::text(), QStringLiteral("Bit 31: Start"));
    QToolTip::hideText();
}

class PaintedArea : public QObject
{
public:
    QRegion region;
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Paint)
            region += static_cast<QPaintEvent *>(event)->region();
        return false;
    }
};

TEST_F(WordViewTest, OnlyWhatChangedIsPaintedAgain)
{
    QCoreApplication::processEvents();
    PaintedArea painted;
    view.installEventFilter(&painted);
    view.setWord(0, 0, 0, 0ms);
    QCoreApplication::processEvents();
    EXPECT_TRUE(painted.region.isEmpty());
    view.setWord(0x8001, 0x8001, 0, 0ms);
    QCoreApplication::processEvents();
    EXPECT_EQ(painted.region, QRegion(view.bitRect(0)) + view.bitRect(15));
}

} // namespace
} // namespace codewheel
