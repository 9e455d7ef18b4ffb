// SPDX-License-Identifier: GPL-3.0-or-later
// The cam editor with an encoder whose cams have limits, hysteresis and polarity.
#include "catalog/catalog.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "project/project.h"
#include "tests/support/model_tester.h"
#include "tests/widgets/cams/cam_editor_test.h"
#include "widgets/cams/cam_program_strip.h"
#include "widgets/cams/cam_table.h"
#include "widgets/cams/cam_table_model.h"

#include <QTemporaryDir>

namespace codewheel {
namespace {

using test::fraba;

class CamsOfASensor : public test::CamEditorTest
{
protected:
    CamsOfASensor()
    {
        project.setProject(projectOf(ring.bus.structure()), {});
        DeviceDescription sensor = *plannedDescription(project.device(fraba), ring.catalog);
        sensor.key = QStringLiteral("sensor");
        sensor.capabilities.cams = CamAbilities{.programs = 1,
                                                .cams = 4,
                                                .isCyclic = false,
                                                .hasMode = false,
                                                .hasShift = false,
                                                .hasHysteresis = true,
                                                .hasPolarity = true};
        editor.setEncoder({fraba, sensor});
    }

    CamTable &table() { return *editor.findChild<CamTable *>(); }
    QAbstractItemModel &model() { return *table().model(); }
    QModelIndex at(int cam, int column) { return model().index(cam, column); }
    void set(int cam, int column, int value)
    {
        EXPECT_TRUE(model().setData(at(cam, column), value, Qt::EditRole));
    }
    void invert(int cam)
    {
        EXPECT_TRUE(model().setData(at(cam, CamTableModel::polarityColumn), Qt::Checked, Qt::CheckStateRole));
    }
};

TEST_F(CamsOfASensor, ShowWhatTheyHaveAndNothingElse)
{
    const test::ModelTester tester{model()};
    EXPECT_EQ(model().rowCount(), 4);
    EXPECT_FALSE(table().isColumnHidden(CamTableModel::hysteresisColumn));
    EXPECT_FALSE(table().isColumnHidden(CamTableModel::polarityColumn));
    EXPECT_FALSE(editor.findChild<CamProgramStrip *>()->isVisible()) << "there is one program";
    EXPECT_FALSE(editor.findChild<CamShiftSpin *>()->isVisible());
    EXPECT_FALSE(action("Run this program in the encoder").isVisible());

    editor.setEncoder(&encoder());
    EXPECT_EQ(model().rowCount(), 8);
    EXPECT_TRUE(table().isColumnHidden(CamTableModel::hysteresisColumn));
    EXPECT_TRUE(table().isColumnHidden(CamTableModel::polarityColumn));
    EXPECT_TRUE(editor.findChild<CamProgramStrip *>()->isVisible());
    EXPECT_TRUE(editor.findChild<CamShiftSpin *>()->isVisible());
    EXPECT_TRUE(action("Run this program in the encoder").isVisible());
}

TEST_F(CamsOfASensor, AreKeptInProjectAndFile)
{
    set(2, CamTableModel::stopColumn, 500);
    set(2, CamTableModel::hysteresisColumn, 3);
    invert(2);
    const Cam expected{0, 500, false, 3, true};
    ASSERT_EQ(project.device(fraba).wantedCams.size(), 1U);
    EXPECT_EQ(project.device(fraba).wantedCams.front().cam.at(2), expected);

    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("cams.json"));
    ASSERT_TRUE(editor.save(file));
    project.undoStack().undo();
    EXPECT_FALSE(sheet().cam(2).isInverted);
    EXPECT_TRUE(editor.load(file)) << message().toStdString();
    EXPECT_EQ(sheet().cam(2), expected);
}

TEST_F(CamsOfASensor, DoNotGoThroughZero)
{
    set(0, CamTableModel::startColumn, 300);
    EXPECT_EQ(sheet().cam(0), (Cam{300, 300})) << "the stop goes along";
    set(0, CamTableModel::stopColumn, 100);
    EXPECT_EQ(sheet().cam(0), (Cam{100, 100}));
    sheet().setCam(0, {200, 100, true}, {});
    EXPECT_EQ(sheet().cam(0), (Cam{100, 100})) << "as where the ruler ends";
}

TEST_F(CamsOfASensor, AreNotWrittenToAnEncoderThatDoesNotKnowThem)
{
    set(2, CamTableModel::hysteresisColumn, 3);
    editor.setEncoder(&encoder());
    tellAll();
    trigger("Write…");
    EXPECT_FALSE(review().isVisible());
    EXPECT_TRUE(message().contains(QStringLiteral("Cam 2 has a hysteresis or a polarity")))
        << message().toStdString();
}

} // namespace
} // namespace codewheel
