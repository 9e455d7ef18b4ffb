// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/support/places.h"
#include "tests/widgets/cams/cam_test.h"
#include "widgets/cams/cam_table.h"
#include "widgets/cams/cam_table_model.h"
#include "widgets/cams/position_input.h"

#include <QAbstractItemModel>
#include <QCoreApplication>
#include <QEvent>
#include <QModelIndex>
#include <QPoint>
#include <QRect>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::manualCam;
using test::manualValue;

class CamTableTest : public test::CamSheetTest
{
protected:
    CamTableTest()
    {
        table.resize(table.sizeHint());
        table.show();
        table.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&table));
        table.setFocus();
    }
    QModelIndex at(std::size_t cam, int column) { return model().index(static_cast<int>(cam), column); }
    QAbstractItemModel &model() { return *table.model(); }
    QString text(std::size_t cam, int column) { return at(cam, column).data().toString(); }
    void choose(std::size_t cam, int column) { table.setCurrentIndex(at(cam, column)); }
    void key(int which) { QTest::keyClick(&table, static_cast<Qt::Key>(which)); }
    PositionInput *field()
    {
        for (auto *input : table.viewport()->findChildren<PositionInput *>())
            if (input->isVisible())
                return input;
        return nullptr;
    }
    void type(const char *text, Qt::Key end = Qt::Key_Return)
    {
        ASSERT_NE(field(), nullptr);
        field()->selectAll();
        QTest::keyClicks(field(), QString::fromLatin1(text));
        QTest::keyClick(field(), end);
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    CamTable table{sheet};
    const test::ModelTester tester{*table.model()};
};

TEST_F(CamTableTest, ShowsTheProgramOfTheManual)
{
    EXPECT_EQ(text(manualCam, CamTableModel::startColumn), QStringLiteral("21"));
    EXPECT_EQ(text(manualCam, CamTableModel::stopColumn), QStringLiteral("531"));
    EXPECT_EQ(at(manualCam, CamTableModel::camColumn).data(Qt::CheckStateRole).toInt(), Qt::Checked);
    EXPECT_EQ(at(0, CamTableModel::camColumn).data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
    EXPECT_EQ(text(manualCam, CamTableModel::encoderColumn), QStringLiteral("unknown"));
}

TEST_F(CamTableTest, AnExactPositionIsTypedAndTakenBack)
{
    sheet.setLargest(33'554'431);
    choose(0, CamTableModel::stopColumn);
    key(Qt::Key_Return);
    type("0x1FFFFFF");
    EXPECT_EQ(sheet.cam(0).stop, 33'554'431);
    undo();
    EXPECT_EQ(sheet.cam(0), Cam());
    redo();
    EXPECT_EQ(sheet.cam(0).stop, 33'554'431);
}

TEST_F(CamTableTest, PositionsBeyondTheRangeAreNotCutOff)
{
    const auto showsAll = [this](int column) {
        const int width = table.columnWidth(column);
        table.resizeColumnToContents(column);
        return width >= table.columnWidth(column);
    };
    sheet.setLargest({});
    sheet.setCam(2, {3'400'000, 13'400'000, true}, {});
    sheet.setLargest(8191);
    EXPECT_TRUE(showsAll(CamTableModel::startColumn));
    EXPECT_TRUE(showsAll(CamTableModel::stopColumn));
    undo();
    sheet.setCam(2, {8191, 3'400'000, true}, {}); // as from a file or the encoder
    EXPECT_TRUE(showsAll(CamTableModel::stopColumn));
}

TEST_F(CamTableTest, TabGoesFromTheStartToTheStopAndToTheNextCam)
{
    choose(0, CamTableModel::startColumn);
    key(Qt::Key_Return);
    type("100", Qt::Key_Tab);
    type("200", Qt::Key_Tab);
    type("300");
    EXPECT_EQ(sheet.cam(0), (Cam{100, 200, false}));
    EXPECT_EQ(sheet.cam(1), (Cam{300, 0, false}));
}

TEST_F(CamTableTest, APositionBeyondTheLargestIsSaidAndStaysInItsField)
{
    QString wrong;
    QObject::connect(&table, &CamTable::inputChecked, [&](const QString &sentence) { wrong = sentence; });
    choose(manualCam, CamTableModel::stopColumn);
    key(Qt::Key_Return);
    type("1000");
    EXPECT_EQ(wrong, QStringLiteral("Cam 3 cannot start or stop at 1000. Give a position from 0 to 999."));
    ASSERT_NE(field(), nullptr);
    EXPECT_EQ(field()->text(), QStringLiteral("1000"));
    EXPECT_FALSE(table.finishEditing());
    EXPECT_EQ(sheet.cam(manualCam), manualValue);
    QTest::keyClick(field(), Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_TRUE(wrong.isEmpty());
    EXPECT_TRUE(table.finishEditing());
}

TEST_F(CamTableTest, WhatIsTypedIsNotOverwrittenByTheBus)
{
    choose(manualCam, CamTableModel::startColumn);
    key(Qt::Key_Return);
    field()->selectAll();
    QTest::keyClicks(field(), QStringLiteral("77"));
    sheet.setLive({.on = {false, false, false, true}, .isTold = true, .position = {}});
    EXPECT_EQ(field()->text(), QStringLiteral("77"));
    EXPECT_EQ(text(manualCam, CamTableModel::stateColumn), QStringLiteral("on"));
    EXPECT_EQ(text(0, CamTableModel::stateColumn), QStringLiteral("off"));
}

TEST_F(CamTableTest, SpaceTicksAndDeleteClears)
{
    choose(manualCam, CamTableModel::startColumn);
    key(Qt::Key_Space);
    EXPECT_FALSE(sheet.cam(manualCam).active);
    key(Qt::Key_Space);
    key(Qt::Key_Delete);
    EXPECT_EQ(sheet.cam(manualCam), Cam());
    EXPECT_EQ(steps(), 3);
    undo();
    EXPECT_EQ(sheet.cam(manualCam), manualValue);
}

TEST_F(CamTableTest, AClickOnTheTickMakesACamActive)
{
    const QRect cell = table.visualRect(at(0, CamTableModel::camColumn));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, QPoint(cell.left() + 12, cell.center().y()));
    EXPECT_TRUE(sheet.cam(0).active);
}

TEST_F(CamTableTest, SaysWhatDiffersFromTheEncoder)
{
    CamSheet::KnownPrograms known;
    known.at(0) = CamSheet::KnownProgram{sheet.program()};
    known.at(0)->program.cam.at(manualCam).stop = 500;
    sheet.setKnown(known);
    EXPECT_EQ(text(manualCam, CamTableModel::encoderColumn), QStringLiteral("differs"));
    EXPECT_EQ(text(0, CamTableModel::encoderColumn), QStringLiteral("same"));
    const QString tip = at(manualCam, CamTableModel::encoderColumn).data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(tip.contains(QStringLiteral("The encoder has 21 to 500, active."))) << tip.toStdString();
}

TEST_F(CamTableTest, AnotherProgramAndAnotherDocumentAreShownAtOnce)
{
    sheet.setNumber(2);
    EXPECT_EQ(text(manualCam, CamTableModel::stopColumn), QStringLiteral("0"));
    sheet.setNumber(1);
    EXPECT_EQ(text(manualCam, CamTableModel::stopColumn), QStringLiteral("531"));
    CamDocument other(project, "9.0"_ring);
    sheet.setDocument(other);
    EXPECT_EQ(text(manualCam, CamTableModel::stopColumn), QStringLiteral("0"));
}

} // namespace
} // namespace codewheel
