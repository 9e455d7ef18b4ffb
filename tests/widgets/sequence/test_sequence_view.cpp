// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/support/old_file.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/sequence/sequence_model.h"
#include "widgets/sequence/sequence_view.h"

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QIODevice>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::fraba;
using Words = std::vector<Word>;

class SequenceViewTest : public testing::Test
{
protected:
    SequenceViewTest()
    {
        view.resize(800, 300);
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
        view.setEncoder(&ring.encoder(fraba));
    }
    QPushButton &button(const char *name)
    {
        for (auto *each : view.findChildren<QPushButton *>())
            if (each->accessibleName() == QLatin1String(name))
                return *each;
        ADD_FAILURE() << "no " << name;
        std::abort();
    }
    QPushButton &send() { return button("Send the sequence"); }
    void stopBy(int choice) { button("Stop the sequence").menu()->actions().at(choice)->trigger(); }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        table.setFocus();
        QTest::keyClick(&table, which, modifiers);
    }
    void paste(const char *text)
    {
        QApplication::clipboard()->setText(QString::fromLatin1(text));
        key(Qt::Key_V, Qt::ControlModifier);
    }
    void typeWord(const char *text)
    {
        auto *editor = qobject_cast<QLineEdit *>(QApplication::focusWidget());
        ASSERT_TRUE(editor);
        QTest::keyClicks(editor, QString::fromLatin1(text));
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    Words words() const { return view.list().words; }
    QString message() const
    {
        const auto *shown = view.findChild<InlineMessage *>();
        return shown->isVisible() ? shown->sentence() : QString();
    }
    QString cell(int row, int column) const { return model.index(row, column).data().toString(); }

    test::TrainingBusSession ring;
    SequenceView view;
    QTableView &table = *view.findChild<QTableView *>();
    SequenceModel &model = *view.findChild<SequenceModel *>();
    test::ModelTester tester{model};
};

TEST_F(SequenceViewTest, ThreeWordsAreInSightHoweverLowThePanel)
{
    paste("020000FF\n04000001\n06000003\n80000000");
    view.resize(view.minimumSizeHint());
    QCoreApplication::processEvents();
    EXPECT_GE(table.viewport()->height(), 3 * table.rowHeight(0));
}

TEST_F(SequenceViewTest, WithoutAnEncoderItSaysWhatBelongsHere)
{
    view.setEncoder(nullptr);
    EXPECT_TRUE(view.findChild<EmptyState *>()->isVisible());
    EXPECT_FALSE(table.isVisible());
}

TEST_F(SequenceViewTest, WordsAreAddedTypedMovedAndRemovedByKeys)
{
    key(Qt::Key_Insert);
    typeWord("20000FFh");
    key(Qt::Key_Insert);
    typeWord("80000000");
    EXPECT_EQ(words(), (Words{0x020000FF, 0x80000000}));
    EXPECT_EQ(cell(0, SequenceModel::meaning), QStringLiteral("Parameter 1 steps = 255"));
    key(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(words(), (Words{0x80000000, 0x020000FF}));
    key(Qt::Key_Down, Qt::AltModifier);
    key(Qt::Key_Delete);
    EXPECT_EQ(words(), (Words{0x020000FF}));
}

TEST_F(SequenceViewTest, AWordThatIsNoneChangesNothing)
{
    paste("020000FF");
    table.edit(model.index(0, SequenceModel::word));
    typeWord("0200000FF");
    EXPECT_EQ(words(), Words{0x020000FF});
    EXPECT_TRUE(message().contains(QLatin1String("has 9 digits"))) << message().toStdString();
}

TEST_F(SequenceViewTest, AWordThatIsRefusedStaysInItsFieldAndNothingIsSent)
{
    paste("020000FF");
    table.edit(model.index(0, SequenceModel::word));
    typeWord("0200000FF");
    auto *field = table.viewport()->findChild<QLineEdit *>();
    ASSERT_NE(field, nullptr);
    send().setFocus();
    send().click();
    EXPECT_EQ(field->text(), QStringLiteral("0200000FF"));
    EXPECT_TRUE(message().contains(QLatin1String("has 9 digits"))) << message().toStdString();
    EXPECT_FALSE(view.isSending());
    QTest::keyClick(field, Qt::Key_Backspace);
    EXPECT_EQ(message(), QString());
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::processEvents();
    EXPECT_EQ(words(), Words{0x0200000F});
}

TEST_F(SequenceViewTest, APastedColumnGoesBelowTheSelectedWord)
{
    paste("1\n2\n");
    table.selectRow(0);
    paste("A\nB\n");
    EXPECT_EQ(words(), (Words{1, 0xA, 0xB, 2}));
    paste("C\njunk\n");
    EXPECT_EQ(words(), (Words{1, 0xA, 0xB, 2}));
    EXPECT_TRUE(message().contains(QLatin1String("line 2, \"junk\""))) << message().toStdString();
}

TEST_F(SequenceViewTest, WordsOfAPlcGoOutAndComeBack)
{
    const QString plc = QStringLiteral("16#0200 16#00FF\n16#8000 16#0000\n");
    QApplication::clipboard()->setText(plc);
    key(Qt::Key_V, Qt::ControlModifier);
    table.clearSelection();
    key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), plc);
}

TEST_F(SequenceViewTest, SendsTheManualsWordsEachUntilItIsAcknowledged)
{
    QStringList sent;
    QObject::connect(&ring.encoder(fraba), &EncoderSession::exchanged, &view, [&sent](const Exchange &row) {
        const QString out = QString::number(row.out, 16).toUpper();
        if (sent.isEmpty() || sent.last() != out)
            sent << out;
    });
    paste("020000FF\n04000001\n06000003\n08000000\n80000000\n00000000");
    QTest::mouseClick(&send(), Qt::LeftButton);
    EXPECT_FALSE(send().isEnabled());
    ring.bus.advance(3);
    EXPECT_EQ(cell(0, SequenceModel::state), QStringLiteral("Sending"));
    ring.bus.advance(300);
    EXPECT_EQ(sent,
              (QStringList{QStringLiteral("20000FF"), QStringLiteral("4000001"), QStringLiteral("6000003"),
                           QStringLiteral("8000000"), QStringLiteral("80000000"), QStringLiteral("0")}));
    EXPECT_EQ(message(), QStringLiteral("All 6 words were sent."));
    EXPECT_EQ(cell(5, SequenceModel::state), QStringLiteral("Sent"));
    EXPECT_TRUE(send().isEnabled());
}

TEST_F(SequenceViewTest, WhileItIsSentNothingIsEdited)
{
    paste("020000FF\n80000000");
    QTest::mouseClick(&send(), Qt::LeftButton);
    key(Qt::Key_Delete);
    paste("1");
    EXPECT_EQ(words(), (Words{0x020000FF, 0x80000000}));
    EXPECT_FALSE(model.flags(model.index(0, SequenceModel::word)) & Qt::ItemIsEditable);
}

TEST_F(SequenceViewTest, StoppedItSaysHowFarItCame)
{
    ring.controls->setFault(TrainingFault::slowConfirmation, fraba.node, 1);
    paste("020000FF\n04000001\n80000000");
    QTest::mouseClick(&send(), Qt::LeftButton);
    ring.bus.advance(20); // a FRABA echoes the first word at once, the second only once that is processed
    stopBy(1);
    ring.bus.advance(3000);
    EXPECT_TRUE(message().startsWith(QLatin1String("The job was cancelled."))) << message().toStdString();
    EXPECT_TRUE(message().endsWith(QLatin1String("Sent before that: 1 of 3 words.")))
        << message().toStdString();
    EXPECT_EQ(ring.channel(fraba).out(), 0U);
    EXPECT_TRUE(send().isEnabled());
}

TEST_F(SequenceViewTest, InWatchItIsRefusedOnTheSpot)
{
    ring.bus.setOperate(false);
    ring.bus.advance(5);
    paste("020000FF");
    QTest::mouseClick(&send(), Qt::LeftButton);
    EXPECT_TRUE(message().contains(QLatin1String("Switch to Operate first."))) << message().toStdString();
    EXPECT_TRUE(send().isEnabled());
}

TEST_F(SequenceViewTest, GoesOnWhenAnotherEncoderIsSelected)
{
    paste("020000FF\n80000000\n00000000");
    QTest::mouseClick(&send(), Qt::LeftButton);
    view.setEncoder(nullptr);
    EXPECT_TRUE(table.isVisible());
    ring.bus.advance(300);
    EXPECT_EQ(cell(2, SequenceModel::state), QStringLiteral("Sent"));
    EXPECT_FALSE(table.isVisible());
}

TEST_F(SequenceViewTest, SavesAndLoadsItsFile)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("steps.json"));
    view.setList({.words = {0x020000FF, 0x80000000}, .holdCycles = 9});
    ASSERT_TRUE(view.save(path));
    view.setList({});
    ASSERT_TRUE(view.load(path));
    EXPECT_EQ(view.list(), (WordList{.words = {0x020000FF, 0x80000000}, .holdCycles = 9}));

    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\n\"format\": 1}");
    file.close();
    EXPECT_FALSE(view.load(path));
    EXPECT_TRUE(message().contains(QLatin1String("was not read. Line 1: "))) << message().toStdString();
    EXPECT_EQ(words().size(), 2U);
    EXPECT_FALSE(view.save(folder.filePath(QStringLiteral("no/such/folder.json"))));
    EXPECT_TRUE(message().contains(QLatin1String("was not saved"))) << message().toStdString();
    test::OldFile old;
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &name) { return view.save(name); }));
    EXPECT_TRUE(old.isThere());
    EXPECT_TRUE(message().endsWith(QLatin1String("File too large"))) << message().toStdString();
}

} // namespace
} // namespace codewheel
