// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/breakage.h"
#include "tests/support/old_file.h"
#include "tests/widgets/cams/cam_editor_test.h"

#include <QFile>
#include <QTemporaryDir>

namespace codewheel {
namespace {

using test::manualCam;
using test::manualValue;

class CamEditorFiles : public test::CamEditorTest
{
protected:
    QString path(const char *name) const { return folder.filePath(QLatin1String(name)); }
    QString keep(const char *name, const QByteArray &content)
    {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
        return file.fileName();
    }
    void setManualCamIn(unsigned number)
    {
        sheet().setNumber(number);
        setManualCam();
    }

    QTemporaryDir folder;
};

TEST_F(CamEditorFiles, AllProgramsComeBackFromAFileInOneStep)
{
    setManualCamIn(1);
    setManualCamIn(8);
    sheet().setShift(25);
    ASSERT_TRUE(editor.save(path("cams.json")));
    trigger("Clear this program");
    sheet().setNumber(1);
    trigger("Clear this program");
    const int steps = sheet().document().undoStack().index();
    ASSERT_TRUE(editor.load(path("cams.json"))) << message().toStdString();
    EXPECT_EQ(program(1).cam.at(manualCam), manualValue);
    EXPECT_EQ(program(8).shift, 25U);
    EXPECT_EQ(sheet().document().undoStack().index(), steps + 1);
    sheet().document().undoStack().undo();
    EXPECT_EQ(program(1).cam.at(manualCam), Cam());
}

TEST_F(CamEditorFiles, AFileOfAnotherProgramIsNotTakenForThisOne)
{
    setManualCamIn(3);
    ASSERT_TRUE(editor.saveProgram(path("three.json")));
    setManualCamIn(1);
    const CamProgram before = program(1);
    EXPECT_FALSE(editor.loadProgram(path("three.json")));
    EXPECT_EQ(message(),
              QStringLiteral("three.json contains cam program 3, not 1. Choose program 3, or another file."));
    EXPECT_EQ(program(1), before);
    EXPECT_EQ(out(), 0U);
    sheet().setNumber(3);
    trigger("Clear this program");
    EXPECT_TRUE(editor.loadProgram(path("three.json")));
    EXPECT_TRUE(message().isEmpty());
    EXPECT_EQ(program(3).cam.at(manualCam), manualValue);
}

TEST_F(CamEditorFiles, AFileOfAnotherDeviceIsNotTaken)
{
    setManualCamIn(1);
    ASSERT_TRUE(editor.saveProgram(path("one.json")));
    QFile good(path("one.json"));
    ASSERT_TRUE(good.open(QIODevice::ReadOnly));
    const QByteArray json = good.readAll();
    trigger("Clear this program");
    const int steps = sheet().document().undoStack().index();
    const QString other = keep("other.json", QByteArray(json).replace("fraba-ocd-ib", "baumer-gxp6w"));
    for (const bool whole : {true, false}) {
        EXPECT_FALSE(whole ? editor.load(other) : editor.loadProgram(other));
        EXPECT_EQ(message(),
                  QStringLiteral("other.json contains cam programs for the device baumer-gxp6w; this "
                                 "encoder is fraba-ocd-ib. Nothing was taken from the file."));
        EXPECT_EQ(sheet().document().undoStack().index(), steps);
    }
    EXPECT_TRUE(
        editor.load(keep("loop.json", QByteArray(json).replace("fraba-ocd-ib", "fraba-ocd-ib-loop2"))));
    EXPECT_EQ(program(1).cam.at(manualCam), manualValue);
}

TEST_F(CamEditorFiles, AFileOfOneProgramShowsItsProgram)
{
    setManualCamIn(3);
    ASSERT_TRUE(editor.saveProgram(path("three.json")));
    sheet().setNumber(1);
    ASSERT_TRUE(editor.load(path("three.json")));
    EXPECT_EQ(sheet().number(), 3U);
}

TEST_F(CamEditorFiles, ABrokenFileIsRefusedWithLineAndReasonAndNothingIsLost)
{
    setManualCam();
    const CamProgram before = program(1);
    ASSERT_TRUE(editor.save(path("cams.json")));
    QFile good(path("cams.json"));
    ASSERT_TRUE(good.open(QIODevice::ReadOnly));
    const QByteArray json = good.readAll();
    for (const Breakage &breakage :
         {Breakage{R"("shift": 0)", R"("shift": 26)", 8, "programs[0].shift", "26 is not between 0 and 25"},
          Breakage{R"("program": 8)", R"("program": 9)", 105, "programs[7].program", "between 1 and 8"},
          Breakage{R"("program": 1)", R"("program": 0)", 7, "programs[0].program", "between 1 and 8"},
          Breakage{R"("stop": 531)", R"("stop": 33554432)", 13, "cams[3].stop", "between 0 and 33554431"},
          Breakage{R"("cam": 7)", R"("cam": 8)", 17, "cams[7].cam", "between 0 and 7"},
          Breakage{"[", "", 20, "", ""}}) {
        EXPECT_FALSE(editor.load(keep("broken.json", brokenBy(breakage, json, Occurs::firstOfSeveral))));
        for (const QString &said : {QStringLiteral("broken.json, line %1").arg(breakage.line),
                                    QString::fromLatin1(breakage.key), QString::fromLatin1(breakage.reason)})
            EXPECT_TRUE(message().contains(said)) << said.toStdString() << " | " << message().toStdString();
        EXPECT_EQ(program(1), before);
    }
}

TEST_F(CamEditorFiles, ACamBeyondTheRangeOfTheEncoderIsNotTaken)
{
    sheet().setCam(0, {0, 33'554'431, true}, {});
    ASSERT_TRUE(editor.saveProgram(path("large.json")));
    trigger("Clear this program");
    encoder().tell(Parameter::steps, 100);
    encoder().tell(Parameter::revolutions, 4096);
    ASSERT_EQ(sheet().largest(), 99);
    EXPECT_FALSE(editor.load(path("large.json")));
    EXPECT_TRUE(message().contains(QStringLiteral("stop"))) << message().toStdString();
    EXPECT_EQ(program(1), CamProgram());
}

TEST_F(CamEditorFiles, WhatCannotBeReadOrSavedIsSaid)
{
    EXPECT_FALSE(editor.load(path("missing.json")));
    EXPECT_TRUE(message().contains(QStringLiteral("missing.json cannot be read"))) << message().toStdString();
    EXPECT_FALSE(editor.save(path("no-such-folder/cams.json")));
    EXPECT_TRUE(message().contains(QStringLiteral("was not saved"))) << message().toStdString();
    test::OldFile old;
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &name) { return editor.save(name); }));
    EXPECT_TRUE(old.isThere());
    EXPECT_TRUE(message().endsWith(QStringLiteral("File too large"))) << message().toStdString();
}

} // namespace
} // namespace codewheel
