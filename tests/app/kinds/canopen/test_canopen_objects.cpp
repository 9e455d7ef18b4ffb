// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a node in the window, and the project.
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/dictionary/object_model.h"

#include <QDockWidget>
#include <QFile>
#include <QTableView>
#include <QToolButton>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::nodeSix;

class CanopenObjectsTest : public test::CanopenWindowTest
{
protected:
    CanopenObjectsTest()
    {
        canActions().training->trigger();
        advance(1'500);
        tree().choose(nodeSix);
        advance(50);
    }
    DictionaryView &objects() { return *window().findChild<DictionaryView *>(); }
    QString cell(const char *object, int column)
    {
        const auto *model = objects().findChild<QTableView *>()->model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->index(row, ObjectModel::object).data().toString() == QLatin1String(object))
                return model->index(row, column).data().toString();
        return {};
    }
};

TEST_F(CanopenObjectsTest, WhatTheProjectWantsOfTheEncoderStandsBesideItsObjects)
{
    shown->project().editDevice(nodeSix, {}, [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 4096}};
    });
    advance(50);
    EXPECT_EQ(cell("6001h:0", ObjectModel::project), QStringLiteral("00001000h = 4096"));
    shown->project().undoStack().undo();
    advance(50);
    EXPECT_EQ(cell("6001h:0", ObjectModel::project), QString());
}

// Its place at the bottom is as high as messages need it.
TEST_F(CanopenObjectsTest, ThePanelOpensWithRoomForItsRowsAndTheirValuesInSight)
{
    for (QAction *action : window().findChildren<QAction *>())
        if (action->shortcut() == QKeySequence(Qt::ALT | Qt::SHIFT | Qt::Key_D))
            action->trigger();
    advance(100);
    const auto &table = *objects().findChild<QTableView *>();
    ASSERT_TRUE(table.isVisible());
    EXPECT_GE(table.viewport()->height(), 8 * table.rowHeight(0));
    EXPECT_LE(table.columnViewportPosition(ObjectModel::value) + table.columnWidth(ObjectModel::value),
              table.viewport()->width());
}

class FileOfAnEncoderTest : public test::CanopenWindowTest
{
protected:
    static QString saved(const QString &path, const QByteArray &bytes)
    {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return path;
    }
    DictionaryView &objects()
    {
        window().findChild<QDockWidget *>(QStringLiteral("canObjectsDock"))->show(); // then it is made
        return *window().findChild<DictionaryView *>();
    }
    QToolButton *toolButton(const char *text)
    {
        for (auto *button : objects().findChildren<QToolButton *>())
            if (button->text() == QLatin1String(text))
                return button;
        return nullptr;
    }
    int rows() { return objects().findChild<QTableView *>()->model()->rowCount(); }
    QString kept() { return shown->project().device(nodeSix).its<CanopenEncoderSettings>().file; }

    const QByteArray oneObject = "[6004]\nParameterName=Position\nDataType=7\nAccessType=ro\n";
};

TEST_F(FileOfAnEncoderTest, IsKeptInTheProjectAndThereWhenItIsOpened)
{
    plan(QStringLiteral("can:can0"), {nodeSix});
    tree().choose(nodeSix);
    advance(50);
    const QString path = saved(folder.filePath(QStringLiteral("rotor.eds")), oneObject);
    ASSERT_TRUE(objects().openFile(path));
    EXPECT_EQ(kept(), path);
    EXPECT_EQ(rows(), 1);
    shown->project().undoStack().undo();
    EXPECT_EQ(kept(), QString());
    EXPECT_GT(rows(), 90);
    shown->project().undoStack().redo();
    EXPECT_EQ(rows(), 1);
    const Project project = shown->project().project();
    shown->project().setProject(Project(), {});
    advance(50);
    shown->project().setProject(project, {});
    tree().choose(nodeSix);
    advance(50);
    EXPECT_EQ(rows(), 1);
}

TEST_F(FileOfAnEncoderTest, IsDroppedByItsButtonOrKeyAndGivenAgainByUndo)
{
    plan(QStringLiteral("can:can0"), {nodeSix});
    tree().choose(nodeSix);
    advance(50);
    auto *button = toolButton("Drop EDS");
    ASSERT_NE(button, nullptr);
    EXPECT_FALSE(button->isEnabled()) << "there is none";
    const QString path = saved(folder.filePath(QStringLiteral("rotor.eds")), oneObject);
    ASSERT_TRUE(objects().openFile(path));
    ASSERT_TRUE(button->isEnabled());
    EXPECT_TRUE(button->toolTip().contains(QStringLiteral("Ctrl+Del"))) << button->toolTip().toStdString();
    button->click();
    advance(50);
    EXPECT_EQ(kept(), QString());
    EXPECT_GT(rows(), 90);
    EXPECT_FALSE(button->isEnabled());
    shown->project().undoStack().undo();
    advance(50);
    EXPECT_EQ(kept(), path);
    EXPECT_EQ(rows(), 1);
    QTest::keyClick(&window(), Qt::Key_D, Qt::AltModifier | Qt::ShiftModifier);
    advance(50);
    QTest::keyClick(objects().findChild<QTableView *>(), Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_EQ(kept(), QString());
    EXPECT_TRUE(QFile::exists(path));
}

TEST_F(FileOfAnEncoderTest, IsFoundBesideTheProject)
{
    plan(QStringLiteral("can:can0"), {nodeSix});
    Project project = shown->project().project();
    devicesOn(project, firstCanBus)[0].set(
        CanopenEncoderSettings{.file = QStringLiteral("/on/another/computer/rotor.eds")});
    saved(folder.filePath(QStringLiteral("rotor.eds")), oneObject);
    shown->project().setProject(project, folder.filePath(QStringLiteral("plant.codewheel")));
    tree().choose(nodeSix);
    advance(50);
    EXPECT_EQ(rows(), 1);
    EXPECT_EQ(kept(), QStringLiteral("/on/another/computer/rotor.eds"));
}

} // namespace
} // namespace codewheel
