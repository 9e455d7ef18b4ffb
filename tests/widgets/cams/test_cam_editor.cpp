// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/cams/cam_editor_test.h"
#include "widgets/cams/cam_program_strip.h"
#include "widgets/cams/cam_range_bar.h"
#include "widgets/cams/cam_ruler.h"
#include "widgets/cams/cam_table.h"
#include "widgets/cams/cam_table_model.h"
#include "widgets/cams/cam_word_picture.h"
#include "widgets/cams/position_input.h"
#include "widgets/look/empty_state.h"

#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::manualCam;
using test::manualValue;

class CamEditorView : public test::CamEditorTest
{
protected:
    CamProgramButton *programButton(unsigned number)
    {
        for (auto *button : editor.findChildren<CamProgramButton *>())
            if (button->number() == number)
                return button;
        return nullptr;
    }
    CamShiftSpin &shift() { return *editor.findChild<CamShiftSpin *>(); }
    bool isAskingForRange() { return editor.findChild<CamRangeBar *>()->isVisible(); }
};

TEST_F(CamEditorView, AnEncoderWithoutCamsIsNamed)
{
    const auto *empty = editor.findChild<EmptyState *>();
    EXPECT_FALSE(empty->isVisible());
    editor.setEncoder(&ring.encoder(baumer));
    EXPECT_TRUE(empty->isVisible());
    EXPECT_EQ(empty->accessibleName(), QStringLiteral("The Baumer GXP6W K3 has no cams."));
    for (const char *tool : {"Read", "Write…", "Compare", "Undo", "Open", "Save"})
        EXPECT_FALSE(action(tool).isEnabled()) << tool;
    editor.setEncoder(nullptr);
    EXPECT_EQ(empty->accessibleName(), QStringLiteral("No encoder is chosen"));
}

TEST_F(CamEditorView, WhatWouldBeUndoneTakesNoRoomInTheToolBar)
{
    auto *tools = editor.findChild<QToolBar *>();
    const auto look = [&](const char *text) {
        return static_cast<QToolButton *>(tools->widgetForAction(&action(text)))->toolButtonStyle();
    };
    for (const auto style : {Qt::ToolButtonIconOnly, Qt::ToolButtonTextBesideIcon}) { // as for want of room
        tools->setToolButtonStyle(style);
        for (const char *text : {"Undo", "Redo", "Open", "Save"})
            EXPECT_EQ(look(text), Qt::ToolButtonIconOnly) << text;
    }
    EXPECT_EQ(look("Compare"), Qt::ToolButtonTextBesideIcon);
}

TEST_F(CamEditorView, OpeningItSendsNothing)
{
    advance(200);
    EXPECT_EQ(out(), 0U);
    EXPECT_FALSE(encoder().runningJob());
}

TEST_F(CamEditorView, WhatWasEditedStaysWhileAnotherEncoderIsChosen)
{
    setManualCam();
    QTest::mouseClick(programButton(5), Qt::LeftButton);
    editor.setEncoder(&ring.encoder(baumer));
    editor.setEncoder(&encoder());
    EXPECT_EQ(program(1).cam.at(manualCam), manualValue);
    EXPECT_EQ(sheet().number(), 5U);
    project.undoStack().undo();
    EXPECT_EQ(program(1).cam.at(manualCam), Cam());
}

TEST_F(CamEditorView, TheRangeIsAskedForWhileNobodyKnowsIt)
{
    EXPECT_TRUE(isAskingForRange());
    EXPECT_EQ(sheet().largest(), 33'554'431);
    auto *field = editor.findChild<CamRangeBar *>()->findChild<PositionInput *>();
    QTest::keyClicks(field, QStringLiteral("999999999"));
    EXPECT_EQ(message(), QStringLiteral("The largest position cannot be 999999999. Give a number from 1 to "
                                        "33554431."));
    field->clear();
    QTest::keyClicks(field, QStringLiteral("999"));
    EXPECT_TRUE(message().isEmpty());
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(sheet().largest(), 999);
    encoder().tell(Parameter::steps, 4096);
    encoder().tell(Parameter::revolutions, 4);
    EXPECT_FALSE(isAskingForRange());
    EXPECT_EQ(sheet().largest(), 4'194'303);
}

TEST_F(CamEditorView, TheLargestPositionThatWasToldIsThatOfOneEncoder)
{
    auto *field = editor.findChild<CamRangeBar *>()->findChild<PositionInput *>();
    QTest::keyClicks(field, QStringLiteral("8191\r"));
    EXPECT_EQ(sheet().largest(), 8191);
    editor.setEncoder(&ring.encoder(test::onLoop));
    EXPECT_TRUE(isAskingForRange());
    EXPECT_EQ(field->text(), QString());
    EXPECT_EQ(message(), QString());
    EXPECT_EQ(sheet().largest(), 33'554'431);
    editor.setEncoder(&encoder());
    EXPECT_EQ(field->text(), QStringLiteral("8191"));
}

TEST_F(CamEditorView, ALargestPositionBelowTheOneShownIsRefused)
{
    encoder().tell(Parameter::startUpMode, 1); // position mode
    advance(40);
    ASSERT_EQ(encoder().latest().position, 12'345);
    auto *field = editor.findChild<CamRangeBar *>()->findChild<PositionInput *>();
    QTest::keyClicks(field, QStringLiteral("8191\r"));
    EXPECT_EQ(message(), QStringLiteral("The largest position cannot be 8191: the encoder shows 12345."));
    EXPECT_EQ(sheet().largest(), 33'554'431);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("12345\r"));
    EXPECT_EQ(message(), QString());
    EXPECT_EQ(sheet().largest(), 12'345);
}

TEST_F(CamEditorView, ProgramsAreChosenByClickAndKey)
{
    setManualCam();
    QTest::mouseClick(programButton(2), Qt::LeftButton);
    EXPECT_EQ(sheet().number(), 2U);
    EXPECT_TRUE(programButton(2)->isChecked());
    EXPECT_TRUE(programButton(1)->toolTip().contains(QStringLiteral("1 of 8 cams are active.")));
    QTest::keyClick(programButton(2), Qt::Key_7);
    EXPECT_EQ(sheet().number(), 7U);
    for (const auto &[key, number] : {std::pair(Qt::Key_0, "0"), std::pair(Qt::Key_9, "9")}) {
        QTest::keyClick(programButton(7), key);
        EXPECT_EQ(message(), QStringLiteral("There is no cam program %1. Choose a program from 1 to 8.")
                                 .arg(QLatin1String(number)));
        EXPECT_EQ(sheet().number(), 7U);
    }
    QTest::keyClick(programButton(7), Qt::Key_1);
    EXPECT_TRUE(message().isEmpty());
    EXPECT_EQ(sheet().cam(manualCam), manualValue);
}

TEST_F(CamEditorView, WhatIsNoNumberIsToldAsSuch)
{
    shift().setFocus();
    shift().selectAll();
    QTest::keyClicks(&shift(), QStringLiteral("2.5"));
    EXPECT_EQ(message(), QStringLiteral("\"2.5\" is not a whole number. Digits only, for example 1000."));
    shift().selectAll();
    QTest::keyClicks(&shift(), QStringLiteral("two"));
    EXPECT_EQ(message(), QStringLiteral("\"two\" is not a number."));
    QTest::keyClick(&shift(), Qt::Key_Escape);
    EXPECT_EQ(message(), QString());
    EXPECT_EQ(sheet().program().shift, 0U);
    auto &table = *editor.findChild<CamTable *>();
    table.edit(table.model()->index(0, CamTableModel::startColumn));
    auto *field = table.viewport()->findChild<PositionInput *>();
    ASSERT_NE(field, nullptr);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("ten"));
    EXPECT_EQ(message(), QStringLiteral("\"ten\" is not a number."));
    QTest::keyClick(field, Qt::Key_Escape);
}

TEST_F(CamEditorView, AShiftThatDoesNotExistIsSaidAndNotTaken)
{
    shift().setFocus();
    shift().selectAll();
    QTest::keyClicks(&shift(), QStringLiteral("26"));
    EXPECT_EQ(message(), QStringLiteral("The shift cannot be 26. Give a value from 0 to 25."));
    EXPECT_EQ(sheet().program().shift, 0U);
    trigger("Read");
    EXPECT_FALSE(encoder().runningJob()); // that comes first
    EXPECT_EQ(out(), 0U);
    shift().selectAll();
    QTest::keyClicks(&shift(), QStringLiteral("7"));
    EXPECT_TRUE(message().isEmpty());
    QTest::keyClick(&shift(), Qt::Key_Return);
    EXPECT_EQ(sheet().program().shift, 7U);
    sheet().document().undoStack().undo();
    EXPECT_EQ(shift().value(), 0);
}

TEST_F(CamEditorView, ThePictureOfTheWordTellsTheBitsOfThePosition)
{
    const auto *word = editor.findChild<CamWordPicture *>();
    sheet().setLargest(33'554'431);
    EXPECT_EQ(
        word->valueText(),
        QStringLiteral("D24 to D8: bits 16 to 0 of the position. D7 to D0: cams 7 to 0. D31: not valid."));
    sheet().setShift(8);
    EXPECT_TRUE(word->valueText().contains(QStringLiteral("bits 24 to 8")))
        << word->valueText().toStdString();
    sheet().setShift(20);
    EXPECT_TRUE(word->valueText().contains(QStringLiteral("bits 24 to 20")));
    sheet().setShift(25);
    EXPECT_TRUE(word->valueText().contains(QStringLiteral("No part of the position")));
}

TEST_F(CamEditorView, InPositionModeItTellsWhatTheCamsWouldBe)
{
    tellAll();
    ring.controls->turnTo(fraba.node, 300);
    setManualCam();
    advance(60);
    EXPECT_EQ(sheet().isOn(manualCam), true);
    EXPECT_FALSE(sheet().live().isTold);
    EXPECT_EQ(sheet().live().position, (CamLive::Position{300, 300}));
    ring.controls->turnTo(fraba.node, 0x214); // one past the stop
    advance(60);
    EXPECT_EQ(sheet().isOn(manualCam), false);
    sheet().setCam(manualCam, {33'554'000, 0x214, true}, {}); // through zero
    EXPECT_EQ(sheet().isOn(manualCam), true);
}

TEST_F(CamEditorView, WithoutAModeNothingIsSaidOfTheCams)
{
    setManualCam();
    advance(60);
    EXPECT_EQ(sheet().isOn(manualCam), std::nullopt);
    EXPECT_EQ(sheet().live().position, std::nullopt);
}

} // namespace
} // namespace codewheel
