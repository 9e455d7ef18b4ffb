// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/cams/cam_test.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/cams/cam_document.h"

#include <QSignalSpy>

namespace codewheel {
namespace {

using test::fraba;
using test::manualCam;
using test::manualValue;

CamProgram programWith(unsigned number, std::size_t cam, const Cam &value)
{
    CamProgram program;
    program.number = number;
    program.cam.at(cam) = value;
    return program;
}

TEST(CamDocumentTest, NobodyHasSetAnythingAtFirst)
{
    ProjectDocument project;
    CamDocument document(project, fraba);
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        EXPECT_EQ(document.program(number), (CamProgram{.number = number}));
}

TEST(CamDocumentTest, AGestureIsOneStepHoweverManyFramesItHas)
{
    ProjectDocument project;
    CamDocument document(project, fraba);
    const CamDocument::Gesture drag = document.newGesture();
    for (std::int64_t stop = 22; stop <= 0x213; ++stop)
        document.setProgram(programWith(1, manualCam, {0x15, stop, true}), QStringLiteral("drag"), drag);
    EXPECT_EQ(document.undoStack().count(), 1);
    EXPECT_EQ(document.program(1).cam.at(manualCam), manualValue);
    document.undoStack().undo();
    EXPECT_EQ(document.program(1), (CamProgram{.number = 1}));
    document.undoStack().redo();
    EXPECT_EQ(document.program(1).cam.at(manualCam), manualValue);
}

TEST(CamDocumentTest, TwoGesturesAreTwoSteps)
{
    ProjectDocument project;
    CamDocument document(project, fraba);
    const CamDocument::Gesture first = document.newGesture();
    document.setProgram(programWith(1, 0, {1, 2, true}), {}, first);
    document.setProgram(programWith(1, 0, {1, 3, true}), {}, first);
    document.setProgram(programWith(2, 0, {1, 3, true}), {}, document.newGesture());
    EXPECT_EQ(document.undoStack().count(), 2);
}

TEST(CamDocumentTest, AGestureThatEndsWhereItBeganLeavesNoStep)
{
    ProjectDocument project;
    CamDocument document(project, fraba);
    const CamDocument::Gesture drag = document.newGesture();
    document.setProgram(programWith(1, 0, {1, 2, true}), {}, drag);
    document.setProgram(CamProgram{.number = 1}, {}, drag);
    EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(CamDocumentTest, SettingWhatIsThereIsNoStep)
{
    ProjectDocument project;
    CamDocument document(project, fraba);
    QSignalSpy changes(&document, &CamDocument::programChanged);
    document.setProgram(CamProgram{.number = 3}, {});
    document.setPrograms({CamProgram{.number = 1}, CamProgram{.number = 2}}, {});
    EXPECT_EQ(document.undoStack().count(), 0);
    EXPECT_EQ(changes.count(), 0);
}

TEST(CamDocumentTest, AFileOfAllProgramsIsTakenBackInOneStep)
{
    ProjectDocument project;
    CamDocument document(project, fraba);
    document.setProgram(programWith(2, 7, {5, 6, true}), {});
    document.setPrograms({programWith(1, 0, {1, 2, true}), programWith(2, 0, {3, 4, true})},
                         QStringLiteral("open"));
    EXPECT_EQ(document.undoStack().count(), 2);
    document.undoStack().undo();
    EXPECT_EQ(document.program(1), (CamProgram{.number = 1}));
    EXPECT_EQ(document.program(2), programWith(2, 7, {5, 6, true}));
}

using CamSheetStates = test::CamSheetTest;

TEST_F(CamSheetStates, OnlyWhatIsKnownOfTheEncoderIsCompared)
{
    EXPECT_EQ(sheet.differs(1), std::nullopt);
    CamSheet::KnownPrograms known;
    known.at(0) = CamSheet::KnownProgram{sheet.program()};
    sheet.setKnown(known);
    EXPECT_EQ(sheet.differs(1), false);
    EXPECT_EQ(sheet.differs(2), std::nullopt);
    sheet.setShift(7);
    EXPECT_EQ(sheet.differs(1), true);
    undo();
    EXPECT_EQ(sheet.differs(1), false);
}

} // namespace
} // namespace codewheel
