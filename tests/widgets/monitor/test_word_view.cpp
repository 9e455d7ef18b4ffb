// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"
#include "kinds/interbus/words/profiles.h"
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

constexpr QSize inTwoRows(600, 200); // large cells too

class WordViewTest : public testing::Test
{
protected:
    WordViewTest()
    {
        window.resize(1400, 200);
        view.resize(view.sizeHint());
        window.show();
        window.activateWindow();
        view.setFocus();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    ~WordViewTest() override { applyAppearance(*qApp, {.scheme = Scheme::light}); }

    void click(int bit) { QTest::mouseClick(&view, Qt::LeftButton, {}, view.bitRect({0, bit}).center()); }
    QList<int> toggledBits() const
    {
        QList<int> bits;
        for (const QList<QVariant> &signal : toggled)
            bits.append(signal.first().value<WordBit>().bit);
        return bits;
    }
    QImage picture(int bit) { return view.grab(view.bitRect({0, bit})).toImage(); }

    static WordView::Line outLine()
    {
        return {.caption = QStringLiteral("OUT"),
                .place = QStringLiteral("OUT 1.0"),
                .isEditable = true,
                .bitText = [](int bit) { return bit == 31 ? QStringLiteral("Start") : QString(); }};
    }
    static WordView::Line inLine()
    {
        return {.caption = QStringLiteral("IN"), .place = QStringLiteral("IN 1.0")};
    }

    const DeviceDescription k3 = [] {
        DeviceDescription device;
        device.profile = profile::k3;
        return device;
    }();
    QWidget window;
    WordView view{wordForm(32, &k3), {outLine()}, &window};
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
                      view.bitRect({0, 7}).center() - QPoint(0, view.bitRect({0, 7}).height() / 2 + 4));
    EXPECT_EQ(toggledBits(), QList{7});
}

TEST_F(WordViewTest, ReleasedOverAnotherBitNothingIsAsked)
{
    QTest::mousePress(&view, Qt::LeftButton, {}, view.bitRect({0, 7}).center());
    QTest::mouseRelease(&view, Qt::LeftButton, {}, view.bitRect({0, 6}).center());
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, TheGapBetweenGroupsIsNoBit)
{
    QTest::mouseClick(&view, Qt::LeftButton, {},
                      QPoint(view.bitRect({0, 28}).left() - 4, view.bitRect({0, 28}).center().y()));
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, InputWordsDoNotToggle)
{
    WordView in(wordForm(32, &k3), {inLine()}, &window);
    in.resize(in.sizeHint());
    in.show();
    const QSignalSpy toggledIn(&in, &WordView::bitToggled);
    QTest::mouseClick(&in, Qt::LeftButton, {}, in.bitRect({0, 3}).center());
    QTest::keyClick(&in, Qt::Key_Space);
    EXPECT_TRUE(toggledIn.isEmpty());
    EXPECT_EQ(in.focusedBit(), (WordBit{0, 3}));
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
        view.setFocusedBit({0, step.from});
        QTest::keyClick(&view, step.key);
        EXPECT_EQ(view.focusedBit(), (WordBit{0, step.to})) << "from " << step.from << " by key " << step.key;
    }
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, UpAndDownGoToTheBitAboveAndBelow)
{
    WordView both(wordForm(32, &k3), {outLine(), inLine()}, &window);
    both.resize(both.minimumSizeHint().width(), 300);
    both.setFocusedBit({0, 28});
    for (const WordBit below : {WordBit{1, 28}, WordBit{0, 12}, WordBit{1, 12}, WordBit{1, 12}}) {
        QTest::keyClick(&both, Qt::Key_Down);
        EXPECT_EQ(both.focusedBit(), below) << below.word << ", " << below.bit;
    }
    for (const WordBit above : {WordBit{0, 12}, WordBit{1, 28}, WordBit{0, 28}, WordBit{0, 28}}) {
        QTest::keyClick(&both, Qt::Key_Up);
        EXPECT_EQ(both.focusedBit(), above) << above.word << ", " << above.bit;
    }
    QTest::keyClick(&both, Qt::Key_End);
    EXPECT_EQ(both.focusedBit(), (WordBit{0, 0}));
}

// The echo of a handshake shows as columns.
TEST_F(WordViewTest, WordsStandBitUnderBitAndAreShownEachForItself)
{
    WordView both(wordForm(32, &k3), {outLine(), inLine()}, &window);
    both.resize(both.sizeHint());
    both.show();
    for (const int bit : {31, 25, 0}) {
        EXPECT_EQ(both.bitRect({0, bit}).left(), both.bitRect({1, bit}).left());
        EXPECT_GT(both.bitRect({1, bit}).top(), both.bitRect({0, bit}).bottom());
    }
    both.setWord(0, 0x0200'00FF, 0, 0, 0ms);
    both.setWord(1, 0xC200'0000, 0xC200'0000, 0x8000'0000, 0ms);
    EXPECT_TRUE(both.isStaged({0, 25}));
    EXPECT_FALSE(both.isStaged({1, 25}));
    EXPECT_TRUE(both.isSet({1, 31}));
    EXPECT_FALSE(both.isSet({0, 31}));
    EXPECT_TRUE(both.isMarked({1, 31}));
    EXPECT_FALSE(both.isMarked({0, 31}));
    EXPECT_EQ(both.bitName({1, 31}), QStringLiteral("IN 1.0 bit 31"));
    const QSignalSpy asked(&both, &WordView::bitToggled);
    QTest::mouseClick(&both, Qt::LeftButton, {}, both.bitRect({1, 25}).center());
    EXPECT_TRUE(asked.isEmpty());
    QTest::mouseClick(&both, Qt::LeftButton, {}, both.bitRect({0, 25}).center());
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(asked.first().first().value<WordBit>(), (WordBit{0, 25}));
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
    view.toggleBit({0, 3});
    EXPECT_TRUE(toggled.isEmpty());
}

TEST_F(WordViewTest, HalfAnEditedWordIsMarkedAsNotSent)
{
    view.setWord(0, 0x0200'00FF, 0x0000'00FF, 0, 0ms);
    EXPECT_TRUE(view.isStaged({0, 25}));
    EXPECT_FALSE(view.isStaged({0, 0}));
    const QImage staged = picture(25);
    view.setWord(0, 0x0200'00FF, 0x0200'00FF, 0, 0ms);
    EXPECT_NE(picture(25), staged);
}

TEST_F(WordViewTest, AChangedBitIsMarkedForHalfASecondEvenIfItChangedBack)
{
    view.setWord(0, 0, 0, 0, 900ms);
    const QImage quiet = picture(4);
    view.setWord(0, 0, 0, 0x10, 1000ms);
    EXPECT_NE(picture(4), quiet);
    view.setWord(0, 0, 0, 0, 1499ms);
    EXPECT_TRUE(view.isMarked({0, 4}));
    view.setWord(0, 0, 0, 0, 1500ms);
    EXPECT_FALSE(view.isMarked({0, 4}));
    EXPECT_EQ(picture(4), quiet);
}

TEST_F(WordViewTest, AMarkDoesNotOutliveItsBus)
{
    view.setWord(0, 0, 0, 0x10, 60s);
    view.setWord(0, 0, 0, 0, 0ms);
    EXPECT_FALSE(view.isMarked({0, 4}));
}

TEST_F(WordViewTest, StandsInOneRowWhereItIsWideEnoughAndElseInTwo)
{
    const int needed = view.sizeHint().width();
    EXPECT_LE(needed, 644) << "a card of 660 pixels has room for it";
    view.resize(needed, 200);
    EXPECT_EQ(view.bitRect({0, 31}).top(), view.bitRect({0, 0}).top());
    EXPECT_EQ(view.bitRect({0, 0}).size(), QSize(18, 26));
    view.resize(needed - 1, 200);
    EXPECT_LT(view.bitRect({0, 31}).top(), view.bitRect({0, 15}).top());
    EXPECT_EQ(view.bitRect({0, 19}).left(), view.bitRect({0, 3}).left());
    EXPECT_EQ(view.bitRect({0, 0}).size(), QSize(22, 26));
    EXPECT_GT(view.heightForWidth(needed - 1), view.heightForWidth(needed));
}

TEST_F(WordViewTest, GroupsStandApart)
{
    const auto expectGaps = [this](int gap) {
        for (const int first : {28, 24, 23, 19, 11, 7, 3})
            EXPECT_EQ(view.bitRect({0, first}).left() - view.bitRect({0, first + 1}).right() - 1, gap)
                << "before bit " << first;
        for (const int inside : {30, 29, 27, 26, 25, 22, 0})
            EXPECT_EQ(view.bitRect({0, inside}).left(), view.bitRect({0, inside + 1}).right() + 1)
                << "before bit " << inside;
    };
    expectGaps(4);
    view.resize(inTwoRows);
    expectGaps(8);
}

// TR manual 2.2: status D31..D28, service number D27..D24, data D23..D0.
TEST_F(WordViewTest, GroupsAreThoseOfTheDevice)
{
    DeviceDescription rod;
    rod.profile = profile::la66;
    WordView ofRod(wordForm(32, &rod), {inLine()}, &window);
    ofRod.resize(500, 200); // two rows
    ofRod.show();
    const auto gapBefore = [&ofRod](int bit) {
        return ofRod.bitRect({0, bit}).left() - ofRod.bitRect({0, bit + 1}).right() - 1;
    };
    for (const int bit : {27, 23, 19, 11, 7, 3})
        EXPECT_EQ(gapBefore(bit), 8) << "before bit " << bit;
    for (const int bit : {30, 29, 28, 26, 25, 24, 22, 0})
        EXPECT_EQ(gapBefore(bit), 0) << "before bit " << bit;
}

TEST_F(WordViewTest, LargeControlsMakeCellsOneAndAHalfTimesAsLarge)
{
    view.resize(inTwoRows);
    EXPECT_EQ(view.bitRect({0, 0}).size(), QSize(22, 26));
    applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = true});
    QCoreApplication::processEvents();
    EXPECT_EQ(view.bitRect({0, 0}).size(), QSize(33, 39));
}

TEST_F(WordViewTest, WhereARowHasNoRoomItsCellsAreNarrower)
{
    view.resize(view.minimumSizeHint());
    EXPECT_EQ(view.bitRect({0, 0}).size(), QSize(18, 26));
    EXPECT_LE(view.bitRect({0, 0}).right(), view.width());
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
    QTest::mouseMove(&view, view.bitRect({0, 31}).center());
    EXPECT_EQ(tips.last, QStringLiteral("OUT 1.0 bit 31: Start"));
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(tips.last, QStringLiteral("OUT 1.0 bit 30"));

    const QPoint point = view.bitRect({0, 31}).center();
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
    view.setWord(0, 0, 0, 0, 0ms);
    QCoreApplication::processEvents();
    EXPECT_TRUE(painted.region.isEmpty());
    view.setWord(0, 0x8001, 0x8001, 0, 0ms);
    QCoreApplication::processEvents();
    EXPECT_EQ(painted.region, QRegion(view.bitRect({0, 0})) + view.bitRect({0, 15}));
}

} // namespace
} // namespace codewheel
