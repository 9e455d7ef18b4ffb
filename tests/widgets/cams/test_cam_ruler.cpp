// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/cams/cam_test.h"
#include "widgets/cams/cam_ruler.h"

#include <QAccessible>
#include <QAccessibleActionInterface>
#include <QAccessibleInterface>
#include <QCoreApplication>
#include <QPoint>
#include <QPointF>
#include <QTest>
#include <QWheelEvent>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::manualCam;
using test::manualValue;

// 1000 positions on 1000 columns: one pixel per position.
class CamRulerTest : public test::CamSheetTest
{
protected:
    CamRulerTest()
    {
        ruler.resize(1016, ruler.sizeHint().height());
        ruler.show();
        ruler.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&ruler));
        ruler.setFocus();
        EXPECT_EQ(ruler.scale().positionsPerColumn(), 1);
    }
    QPoint at(std::size_t cam, double position)
    {
        return {qRound(ruler.scale().x(position)), ruler.rowRect(cam).center().y()};
    }
    void press(std::size_t cam, double position)
    {
        QTest::mouseMove(&ruler, at(cam, position));
        QTest::mousePress(&ruler, Qt::LeftButton, {}, at(cam, position));
    }
    void moveTo(std::size_t cam, double position) { QTest::mouseMove(&ruler, at(cam, position)); }
    void release(std::size_t cam, double position)
    {
        QTest::mouseRelease(&ruler, Qt::LeftButton, {}, at(cam, position));
    }
    void drag(std::size_t cam, double from, double to)
    {
        press(cam, from);
        moveTo(cam, (from + to) / 2);
        moveTo(cam, to);
        release(cam, to);
    }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&ruler, which, modifiers);
    }

    CamRuler ruler{sheet};
};

TEST_F(CamRulerTest, DraggingTheBarMovesTheCamInOneStep)
{
    drag(manualCam, 300, 400);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{121, 631, true}));
    EXPECT_EQ(steps(), 1);
    undo();
    EXPECT_EQ(sheet.cam(manualCam), manualValue);
    redo();
    EXPECT_EQ(sheet.cam(manualCam), (Cam{121, 631, true}));
}

TEST_F(CamRulerTest, DraggingAnEdgeMovesItAlone)
{
    drag(manualCam, 22, 50);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{49, 531, true}));
    drag(manualCam, 531, 600);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{49, 600, true}));
    EXPECT_EQ(steps(), 2);
}

// A gloved finger does not hit a single pixel.
TEST_F(CamRulerTest, AnEdgeIsGraspedFromBesideIt)
{
    drag(manualCam, 15, 25);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{31, 531, true}));
    drag(manualCam, 538, 548);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{31, 541, true}));
}

TEST_F(CamRulerTest, ABarPassesTheEndAndGoesThroughZero)
{
    drag(manualCam, 300, 900);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{621, 131, true}));
    drag(manualCam, 60, 70); // the part at the left end
    EXPECT_EQ(sheet.cam(manualCam), (Cam{631, 141, true}));
    drag(manualCam, 142, 100); // its stop is there
    EXPECT_EQ(sheet.cam(manualCam), (Cam{631, 99, true}));
}

TEST_F(CamRulerTest, AStartDraggedOverTheLeftEndComesInAtTheRight)
{
    press(manualCam, 21);
    QTest::mouseMove(&ruler, at(manualCam, 0));
    QTest::mouseMove(&ruler, QPoint(3, at(manualCam, 0).y()));
    release(manualCam, -5);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{995, 531, true}));
}

TEST_F(CamRulerTest, DraggingInAnEmptyRowDrawsACam)
{
    drag(0, 700, 800);
    EXPECT_EQ(sheet.cam(0), (Cam{700, 800, true}));
    drag(1, 500, 450); // also to the left
    EXPECT_EQ(sheet.cam(1), (Cam{450, 500, true}));
    EXPECT_EQ(steps(), 2);
    undo();
    EXPECT_EQ(sheet.cam(1), Cam());
}

TEST_F(CamRulerTest, AClickOnlyChooses)
{
    press(manualCam, 300);
    release(manualCam, 300);
    EXPECT_EQ(sheet.current(), manualCam);
    press(manualCam, 800); // beside the bar
    moveTo(manualCam, 900);
    release(manualCam, 900);
    EXPECT_EQ(sheet.cam(manualCam), manualValue);
    EXPECT_EQ(steps(), 0);
}

TEST_F(CamRulerTest, EscapeGivesADragUp)
{
    press(manualCam, 300);
    moveTo(manualCam, 400);
    EXPECT_NE(sheet.cam(manualCam), manualValue);
    key(Qt::Key_Escape);
    EXPECT_EQ(sheet.cam(manualCam), manualValue);
    moveTo(manualCam, 500);
    release(manualCam, 500);
    EXPECT_EQ(sheet.cam(manualCam), manualValue);
    EXPECT_EQ(sheet.document().undoStack().count(), 0);
}

TEST_F(CamRulerTest, APixelOfManyPositionsMovesByRoundNumbers)
{
    sheet.setLargest(33'554'431);
    drag(0, 10'000'000, 20'000'000);
    EXPECT_EQ(sheet.cam(0).start % 50'000, 0);
    EXPECT_EQ(sheet.cam(0).stop % 50'000, 0);
    drag(0, static_cast<double>(sheet.cam(0).stop), 33'554'432);
    EXPECT_EQ(sheet.cam(0).stop, 33'554'431); // snaps to the end
}

TEST_F(CamRulerTest, KeysMoveBarAndEdges)
{
    key(Qt::Key_Down);
    key(Qt::Key_Down);
    key(Qt::Key_Down);
    EXPECT_EQ(sheet.current(), manualCam);
    key(Qt::Key_Right);
    key(Qt::Key_Right);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{23, 533, true}));
    EXPECT_EQ(steps(), 1); // a single step, since it was a single movement
    key(Qt::Key_Home);
    key(Qt::Key_Left);
    EXPECT_EQ(sheet.cam(manualCam), (Cam{22, 533, true}));
    key(Qt::Key_End);
    key(Qt::Key_Right, Qt::ShiftModifier);
    const std::int64_t tick = sheet.cam(manualCam).stop - 533;
    EXPECT_TRUE(tick >= 20 && tick % 10 == 0) << tick;
    EXPECT_EQ(steps(), 3);
}

TEST_F(CamRulerTest, KeysMoveNoCamThatNobodyHasSet)
{
    key(Qt::Key_Right);
    EXPECT_EQ(sheet.cam(0), Cam());
    EXPECT_EQ(steps(), 0);
    key(Qt::Key_End);
    key(Qt::Key_Right); // an edge makes one
    EXPECT_EQ(sheet.cam(0), (Cam{0, 1, false}));
}

TEST_F(CamRulerTest, KeysMoveNoCamThatIsOff)
{
    sheet.setCurrent(manualCam);
    const Cam before = sheet.cam(manualCam);
    sheet.setActive(manualCam, false);
    key(Qt::Key_Right);
    EXPECT_EQ(sheet.cam(manualCam).start, before.start);
    EXPECT_EQ(steps(), 1) << "it was switched off, and nothing else";
}

TEST_F(CamRulerTest, SpaceAndDeleteActOnTheCam)
{
    sheet.setCurrent(manualCam);
    key(Qt::Key_Space);
    EXPECT_FALSE(sheet.cam(manualCam).active);
    key(Qt::Key_Delete);
    EXPECT_EQ(sheet.cam(manualCam), Cam());
    EXPECT_EQ(steps(), 2);
}

TEST_F(CamRulerTest, TabVisitsEveryCamAndThenLeaves)
{
    QWidget window;
    ruler.setParent(&window);
    QWidget next(&window);
    next.setFocusPolicy(Qt::StrongFocus);
    QWidget::setTabOrder(&ruler, &next);
    window.resize(1016, 400);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    ruler.setFocus(Qt::TabFocusReason);
    for (std::size_t cam = 0; cam < CamProgram::cams; ++cam) {
        EXPECT_TRUE(ruler.hasFocus());
        EXPECT_EQ(sheet.current(), cam);
        key(Qt::Key_Tab);
    }
    EXPECT_FALSE(ruler.hasFocus());
    ruler.setParent(nullptr);
}

TEST_F(CamRulerTest, TheWheelZoomsAroundTheMouse)
{
    const QPointF mouse(700, 100);
    const double before = ruler.scale().positionAt(mouse.x());
    QWheelEvent turn(mouse, ruler.mapToGlobal(mouse), {}, QPoint(0, 240), Qt::NoButton, {}, Qt::NoScrollPhase,
                     false);
    QCoreApplication::sendEvent(&ruler, &turn);
    EXPECT_LT(ruler.scale().shown(), 500);
    EXPECT_NEAR(ruler.scale().positionAt(mouse.x()), before, 1e-6);
    key(Qt::Key_0);
    EXPECT_TRUE(ruler.scale().showsAll());
}

TEST_F(CamRulerTest, CursorsSayWhatCanBeDone)
{
    moveTo(manualCam, 300);
    EXPECT_EQ(ruler.cursor().shape(), Qt::OpenHandCursor);
    moveTo(manualCam, 21);
    EXPECT_EQ(ruler.cursor().shape(), Qt::SizeHorCursor);
    moveTo(0, 300);
    EXPECT_EQ(ruler.cursor().shape(), Qt::CrossCursor);
    moveTo(manualCam, 800);
    EXPECT_EQ(ruler.cursor().shape(), Qt::ArrowCursor);
}

TEST_F(CamRulerTest, AScreenReaderFindsEightCamsAndCanSwitchThem)
{
    QAccessibleInterface *group = QAccessible::queryAccessibleInterface(&ruler);
    ASSERT_NE(group, nullptr);
    ASSERT_EQ(group->childCount(), 8);
    QAccessibleInterface *cam = group->child(static_cast<int>(manualCam));
    EXPECT_EQ(cam->text(QAccessible::Name), QStringLiteral("Cam 3"));
    EXPECT_TRUE(cam->text(QAccessible::Description).startsWith(QStringLiteral("Cam 3: 21 to 531, active.")))
        << cam->text(QAccessible::Description).toStdString();
    EXPECT_TRUE(cam->state().checked);
    EXPECT_EQ(group->indexOfChild(cam), static_cast<int>(manualCam));
    cam->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
    EXPECT_FALSE(sheet.cam(manualCam).active);
    EXPECT_FALSE(cam->state().checked);
    cam->actionInterface()->doAction(QAccessibleActionInterface::setFocusAction());
    EXPECT_EQ(sheet.current(), manualCam);
}

} // namespace
} // namespace codewheel
