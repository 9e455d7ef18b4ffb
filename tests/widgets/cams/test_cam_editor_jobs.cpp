// SPDX-License-Identifier: GPL-3.0-or-later
// The cam editor and FRABA 1.0 of the training bus: read, write, compare, run.
#include "tests/app/question.h"
#include "tests/widgets/cams/cam_editor_test.h"
#include "widgets/cams/cam_mode_bar.h"
#include "widgets/cams/cam_program_strip.h"
#include "widgets/cams/cam_table.h"
#include "widgets/cams/cam_table_model.h"

#include <QCheckBox>
#include <QLocale>
#include <QPushButton>
#include <QTest>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;
using test::manualCam;
using test::manualValue;

class CamEditorJobs : public test::CamEditorTest
{
protected:
    void writeManualCam()
    {
        setManualCam();
        trigger("Write…");
        ASSERT_TRUE(review().isVisible()) << message().toStdString();
        click("confirmWriteCams");
        finishJob();
    }
    std::optional<CamProgram> known(unsigned number)
    {
        const auto there = encoder().cams(number);
        return there ? std::optional(there->program) : std::nullopt;
    }
};

// Leaving a program stores it if it was changed.
TEST_F(CamEditorJobs, ReadingAnEepromThatIsUsedUpIsAskedFor)
{
    tellAll();
    encoder().setEepromCount({.writes = 500});
    {
        const auto cancels = test::Question::answeredBy(QStringLiteral("Cancel"));
        trigger("Read");
    }
    EXPECT_FALSE(encoder().runningJob());
    encoder().setEepromCount({.writes = 200});
    const test::Question agrees([](QWidget &dialog) {
        dialog.findChild<QCheckBox *>(QStringLiteral("writeNevertheless"))->click();
        dialog.findChild<QPushButton *>(QStringLiteral("writeToEeprom"))->click();
    });
    trigger("Read");
    EXPECT_TRUE(encoder().runningJob());
    finishJob();
}

TEST_F(CamEditorJobs, LeavingAChangedProgramIsCountedAsAnEepromWrite)
{
    tellAll();
    const int before = encoder().eepromWrites();
    writeManualCam();
    EXPECT_EQ(encoder().eepromWrites(), before + 1);
    EXPECT_TRUE(message().contains(QStringLiteral("EEPROM writes: 1"))) << message().toStdString();
}

// What was read once may have been changed by somebody else since: when it was read stands beside it.
TEST_F(CamEditorJobs, WhatTheEncoderHasSaysHowAndWhenItIsKnownAndLooksOldWhileTheBusStops)
{
    tellAll();
    setManualCam();
    const auto &strip = *editor.findChild<CamProgramButton *>();
    EXPECT_TRUE(strip.toolTip().endsWith(QStringLiteral("What the encoder has is not known.")));
    writeManualCam();
    const auto &table = *editor.findChild<CamTable *>()->model();
    const QModelIndex cell = table.index(manualCam, CamTableModel::encoderColumn);
    const auto tip = [&] { return cell.data(Qt::ToolTipRole).toString(); };
    const QString how = QStringLiteral("It was read from the encoder.\n") +
                        QLocale().toString(encoder().dateTime(encoder().cams(1)->at), QLocale::ShortFormat);
    EXPECT_TRUE(tip().endsWith(QStringLiteral("The encoder has the same.\n") + how)) << tip().toStdString();
    EXPECT_TRUE(strip.toolTip().endsWith(how)) << strip.toolTip().toStdString();
    EXPECT_FALSE(cell.data(Qt::ForegroundRole).isValid());

    ring.bus.setRunning(false);
    advance(60);
    EXPECT_TRUE(cell.data(Qt::ForegroundRole).isValid());
    EXPECT_EQ(cell.data(Qt::AccessibleTextRole).toString(), QStringLiteral("same, not up to date"));
    EXPECT_TRUE(tip().endsWith(QStringLiteral("The encoder had the same.\n") + how));
    EXPECT_TRUE(strip.toolTip().contains(QStringLiteral("The encoder had the same.")));
    ring.bus.setRunning(true);
    advance(60);
    EXPECT_FALSE(cell.data(Qt::ForegroundRole).isValid());
    EXPECT_TRUE(strip.toolTip().contains(QStringLiteral("The encoder has the same.")));
}

TEST_F(CamEditorJobs, ReadingTakesTheProgramAndCanBeTakenBack)
{
    tellAll();
    writeManualCam();
    sheet().setCam(manualCam, {1, 2, false}, {});
    trigger("Read");
    finishJob();
    EXPECT_EQ(sheet().cam(manualCam), manualValue);
    EXPECT_TRUE(message().startsWith(QStringLiteral("Program 1 was read."))) << message().toStdString();
    sheet().document().undoStack().undo();
    EXPECT_EQ(sheet().cam(manualCam), (Cam{1, 2, false}));
}

TEST_F(CamEditorJobs, ComparingNamesWhatDiffersAndChangesNothing)
{
    tellAll();
    writeManualCam();
    trigger("Compare");
    finishJob();
    EXPECT_EQ(message(), QStringLiteral("The encoder has the same program 1."));
    sheet().setCam(manualCam, {0x15, 0x200, true}, {});
    sheet().setShift(3);
    trigger("Compare");
    finishJob();
    EXPECT_TRUE(
        message().startsWith(QStringLiteral("Program 1 differs in: cam 3, the shift (the encoder has 0).")))
        << message().toStdString();
    EXPECT_EQ(sheet().cam(manualCam), (Cam{0x15, 0x200, true}));
}

TEST_F(CamEditorJobs, WhereTheModeIsNotKnownItAsksHowToLeaveTheEncoder)
{
    auto &question = *editor.findChild<CamModeBar *>();
    trigger("Read");
    EXPECT_TRUE(question.isVisible());
    EXPECT_FALSE(encoder().runningJob());
    QTest::keyClick(&question, Qt::Key_Escape);
    EXPECT_FALSE(question.isVisible());
    EXPECT_EQ(out(), 0U);
    trigger("Read");
    click("afterwardsPosition");
    EXPECT_TRUE(encoder().runningJob());
    finishJob();
    EXPECT_EQ(encoder().latest().mode, Mode::position);
    EXPECT_EQ(sheet().differs(1), false);
}

TEST_F(CamEditorJobs, ACamBeyondTheLargestPositionIsSaidBeforeAnythingIsSent)
{
    tellAll();
    sheet().setCam(2, {0, 33'554'431, true}, {});
    encoder().tell(Parameter::steps, 4096);
    trigger("Write…");
    EXPECT_FALSE(review().isVisible());
    EXPECT_EQ(message(),
              QStringLiteral("Program 1: Cam 2 cannot start or stop at 33554431. Give a position from 0 "
                             "to 16777215."));
    sheet().setCam(2, {0, 16'777'215, true}, {});
    EXPECT_TRUE(message().isEmpty());
}

// The program does not know that the encoder has fewer positions.
TEST_F(CamEditorJobs, WhatTheEncoderRefusesIsNamedAndNothingIsLost)
{
    tellAll();
    ASSERT_TRUE(encoder().start(SendWords{.words = {0x0200'00FF, 0x8000'0000, 0x0000'0000}}));
    finishJob();
    encoder().tell(Parameter::steps, 8192); // the user is wrong
    sheet().setCam(manualCam, {0x15, 33'000'000, true}, {});
    trigger("Write…");
    click("confirmWriteCams");
    finishJob();
    EXPECT_TRUE(message().contains(QStringLiteral("98000004"))) << message().toStdString();
    EXPECT_EQ(sheet().cam(manualCam), (Cam{0x15, 33'000'000, true}));
}

TEST_F(CamEditorJobs, WatchingSendsNothingAndSaysSo)
{
    tellAll();
    ring.bus.setOperate(false);
    advance(40);
    trigger("Read");
    EXPECT_TRUE(message().contains(QStringLiteral("Operate"))) << message().toStdString();
    ring.bus.setOperate(true);
    advance(40);
    EXPECT_TRUE(message().isEmpty());
}

// Nothing is told, so that the mode would be asked for.
TEST_F(CamEditorJobs, WatchingAsksNothingBeforeItRefuses)
{
    ring.bus.setOperate(false);
    advance(40);
    for (const char *what : {"Read", "Compare", "Write…", "Read all programs"}) {
        trigger(what);
        EXPECT_FALSE(button("afterwardsPosition")) << what;
        EXPECT_TRUE(message().contains(QStringLiteral("Operate"))) << what << message().toStdString();
    }
    ring.bus.setOperate(true);
    advance(40);
    EXPECT_TRUE(message().isEmpty());
    trigger("Read");
    EXPECT_TRUE(button("afterwardsPosition"));
}

TEST_F(CamEditorJobs, TheCamsOfTheRunningProgramAreShownAsTheEncoderTellsThem)
{
    tellAll();
    writeManualCam();
    ring.controls->turnTo(fraba.node, 0x15);
    trigger("Run this program in the encoder");
    finishJob();
    EXPECT_EQ(encoder().latest().mode, Mode::cam);
    EXPECT_TRUE(sheet().live().isTold);
    EXPECT_EQ(sheet().isOn(manualCam), true);
    ring.controls->turnTo(fraba.node, 0x214);
    advance(60);
    EXPECT_EQ(sheet().isOn(manualCam), false);
    trigger("Back to position mode");
    finishJob();
    EXPECT_EQ(encoder().latest().mode, Mode::position);
    EXPECT_FALSE(sheet().live().isTold);
}

TEST_F(CamEditorJobs, AShiftedPositionIsAStretchOfTheRuler)
{
    tellAll();
    sheet().setShift(8);
    writeManualCam();
    ring.controls->turnTo(fraba.node, 1'000'000);
    trigger("Run this program in the encoder");
    finishJob();
    EXPECT_EQ(sheet().live().position, (CamLive::Position{999'936, 1'000'191}));
}

} // namespace
} // namespace codewheel
