// SPDX-License-Identifier: GPL-3.0-or-later
// The cam editor as a page of the window.
#include "tests/app/window_test.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/structure/structure_view.h"

#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class CamsInTheWindow : public test::WindowTest
{
protected:
    CamEditor &editor() { return *window().findChild<CamEditor *>(); }
    CamSheet &sheet() { return *window().findChild<CamSheet *>(); }
    void choose(Place number)
    {
        window().findChild<StructureView *>()->choose(number);
        advance(40);
    }
};

TEST_F(CamsInTheWindow, AKeyShowsThemAndAnotherTheMonitors)
{
    choose(fraba);
    QTest::keyClick(&window(), Qt::Key_F8);
    EXPECT_TRUE(editor().isVisible());
    QTest::keyClick(&window(), Qt::Key_F7);
    EXPECT_FALSE(editor().isVisible());
    EXPECT_TRUE(monitors().isVisible());
}

TEST_F(CamsInTheWindow, AnEncoderWithoutCamsSaysSo)
{
    choose(baumer);
    EXPECT_FALSE(actions().cams->isEnabled());
    EXPECT_TRUE(actions().cams->toolTip().contains(QStringLiteral("has no cams.")))
        << actions().cams->toolTip().toStdString();
    choose(fraba);
    EXPECT_TRUE(actions().cams->isEnabled());
}

TEST_F(CamsInTheWindow, ArePartOfTheProject)
{
    choose(fraba);
    QTest::keyClick(&window(), Qt::Key_F8);
    sheet().setCam(3, {0x15, 0x213, true}, QStringLiteral("move"));
    ASSERT_EQ(shown->project().device(fraba).wantedCams.size(), 1u);
    EXPECT_EQ(shown->project().device(fraba).wantedCams.front().cam.at(3), (Cam{0x15, 0x213, true}));
    EXPECT_FALSE(shown->project().isSaved());
    QTest::keyClick(&editor(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(shown->project().device(fraba).wantedCams.empty());
    EXPECT_EQ(sheet().cam(3), Cam());
}

} // namespace
} // namespace codewheel
