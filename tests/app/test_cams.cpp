// SPDX-License-Identifier: GPL-3.0-or-later
// The cam editor as a page of the window.
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/structure/structure_view.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class CamsInTheWindow : public test::WindowTest
{
protected:
    CamEditor &editor() { return *window().findChild<CamEditor *>(); }
    CamSheet &sheet() { return *window().findChild<CamSheet *>(); }
    void choose(DeviceNumber number)
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

TEST_F(CamsInTheWindow, ClosingAsksForWhatIsKeptNowhere)
{
    choose(fraba);
    sheet().setCam(3, {0x15, 0x213, true}, {});
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Stay"));
        window().close();
        advance(5);
        EXPECT_TRUE(question.text().contains(QStringLiteral("1.0"))) << question.text().toStdString();
    }
    EXPECT_TRUE(window().isVisible());
    EXPECT_TRUE(editor().isVisible());
    ASSERT_TRUE(editor().save(folder.filePath(QStringLiteral("cams.json"))));
    window().close(); // nothing to ask
    advance(5);
    EXPECT_FALSE(window().isVisible());
}

} // namespace
} // namespace codewheel
