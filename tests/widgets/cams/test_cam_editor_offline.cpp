// SPDX-License-Identifier: GPL-3.0-or-later
// The cam editor for an encoder that is planned and not connected.
#include "catalog/catalog.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "project/project.h"
#include "tests/widgets/cams/cam_editor_test.h"
#include "widgets/cams/cam_range_bar.h"
#include "widgets/look/empty_state.h"

#include <QLabel>
#include <QTemporaryDir>

namespace codewheel {
namespace {

using test::fraba;
using test::manualCam;
using test::manualValue;

class OfflineCams : public test::CamEditorTest
{
protected:
    OfflineCams()
    {
        project.setProject(projectOf(ring.bus.structure()), {});
        show(fraba);
    }
    void show(Place number)
    {
        editor.setEncoder({number, *plannedDescription(project.device(number), ring.catalog)});
    }
    bool isAskingForRange() { return editor.findChild<CamRangeBar *>()->isVisible(); }
    void want(const ParameterValues &values)
    {
        project.editDevice(fraba, {}, [&](ProjectDevice &device) { device.wanted = values; });
    }
};

TEST_F(OfflineCams, AreEditedInTheProjectAndUndone)
{
    setManualCam();
    ASSERT_EQ(project.device(fraba).wantedCams.size(), 1U);
    EXPECT_EQ(project.device(fraba).wantedCams.front().cam.at(manualCam), manualValue);
    project.undoStack().undo();
    EXPECT_EQ(sheet().cam(manualCam), Cam());
    EXPECT_EQ(sheet().differs(1), std::nullopt) << "what the encoder has is not known";
}

TEST_F(OfflineCams, NothingThatSendsIsToBeHad)
{
    for (const char *tool : {"Read", "Write…", "Compare", "Run this program in the encoder",
                             "Back to position mode", "Read all programs", "Write all programs…"}) {
        EXPECT_FALSE(action(tool).isEnabled()) << tool;
        EXPECT_TRUE(action(tool).toolTip().startsWith(QStringLiteral("Not connected:"))) << tool;
    }
    for (const char *tool : {"Open", "Save", "Clear this program"})
        EXPECT_TRUE(action(tool).isEnabled()) << tool;
    editor.setEncoder(&encoder());
    EXPECT_TRUE(action("Read").isEnabled());
    EXPECT_TRUE(action("Read").toolTip().startsWith(QStringLiteral("Read this program"))) << "again";
}

TEST_F(OfflineCams, TheRulerGoesAsFarAsTheWantedValues)
{
    EXPECT_TRUE(isAskingForRange());
    want({{Parameter::steps, 4096}, {Parameter::revolutions, 4}});
    EXPECT_FALSE(isAskingForRange());
    EXPECT_EQ(sheet().largest(), 4'194'303);
    project.undoStack().undo();
    EXPECT_TRUE(isAskingForRange());
    project.editDevice(fraba, {}, [](ProjectDevice &device) {
        device.stored = {{Parameter::steps, 8192, Evidence::read, {}},
                         {Parameter::revolutions, 1, Evidence::read, {}}};
    });
    EXPECT_EQ(sheet().largest(), 33'554'431);
    want({{Parameter::revolutions, 4}});
    EXPECT_EQ(sheet().largest(), 8'388'607) << "wanted goes before what it was known to have";
}

TEST_F(OfflineCams, AreKeptInAFileForTheEncoderThatIsPlanned)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("cams.json"));
    setManualCam();
    ASSERT_TRUE(editor.save(file));
    project.undoStack().undo();
    EXPECT_TRUE(editor.load(file));
    EXPECT_EQ(sheet().cam(manualCam), manualValue);
}

TEST_F(OfflineCams, AnEncoderWithoutCamsIsNamed)
{
    show(test::baumer);
    EXPECT_EQ(editor.findChild<EmptyState *>()->accessibleName(),
              QStringLiteral("The Baumer GXP6W K3 has no cams."));
}

} // namespace
} // namespace codewheel
