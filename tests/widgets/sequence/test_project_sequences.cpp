// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequence/project_sequences.h"
#include "widgets/sequence/sequence_view.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

class ProjectSequencesTest : public testing::Test
{
protected:
    const std::vector<ProjectSequence> &sequences() { return document.project().sequences; }
    void type(const std::vector<Word> &words)
    {
        view.setList({.words = words, .holdCycles = view.list().holdCycles});
        QCoreApplication::processEvents();
    }
    void click(const char *button) { bar.findChild<QAbstractButton *>(QLatin1String(button))->click(); }
    QComboBox &names() { return *bar.findChild<QComboBox *>(); }

    ProjectDocument document;
    SequenceView view;
    ProjectSequences bar{document, view};
};

TEST_F(ProjectSequencesTest, TheFirstWordsMakeTheFirstSequence)
{
    QCoreApplication::processEvents();
    EXPECT_TRUE(sequences().empty());
    EXPECT_TRUE(document.isSaved());
    type({0x0200'00FF, 0x8000'0000});
    ASSERT_EQ(sequences().size(), 1u);
    EXPECT_EQ(sequences().front().name, QStringLiteral("Sequence 1"));
    EXPECT_EQ(sequences().front().list.words, (std::vector<Word>{0x0200'00FF, 0x8000'0000}));
    EXPECT_EQ(document.undoStack().count(), 1) << "one step, however many rows";
    document.undoStack().undo();
    EXPECT_TRUE(view.list().words.empty());
    document.undoStack().redo();
    EXPECT_EQ(view.list().words.size(), 2u);
}

TEST_F(ProjectSequencesTest, SeveralAreKeptNamedChosenAndRemoved)
{
    type({1});
    click("addSequence");
    EXPECT_TRUE(view.list().words.empty());
    type({2, 3});
    names().lineEdit()->selectAll();
    QTest::keyClicks(names().lineEdit(), QStringLiteral("preset"));
    QTest::keyClick(names().lineEdit(), Qt::Key_Return);
    ASSERT_EQ(sequences().size(), 2u);
    EXPECT_EQ(sequences()[1].name, QStringLiteral("preset"));
    names().setCurrentIndex(0);
    Q_EMIT names().activated(0);
    EXPECT_EQ(view.list().words, std::vector<Word>{1});
    click("removeSequence");
    ASSERT_EQ(sequences().size(), 1u);
    EXPECT_EQ(view.list().words, (std::vector<Word>{2, 3}));
    document.undoStack().undo();
    EXPECT_EQ(sequences().size(), 2u);
}

TEST_F(ProjectSequencesTest, ANameThatIsGivenUpOrEmptyLeavesTheOneBefore)
{
    type({1});
    const QString before = names().currentText();
    names().lineEdit()->selectAll();
    QTest::keyClicks(names().lineEdit(), QStringLiteral("pre"));
    QTest::keyClick(names().lineEdit(), Qt::Key_Escape);
    EXPECT_EQ(names().currentText(), before);
    names().lineEdit()->selectAll();
    QTest::keyClick(names().lineEdit(), Qt::Key_Delete);
    QTest::keyClick(names().lineEdit(), Qt::Key_Return);
    EXPECT_EQ(names().currentText(), before);
    EXPECT_EQ(sequences().front().name, before);
    EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(ProjectSequencesTest, StepsOfTheCyclesAreOneStepOfUndo)
{
    type({1});
    auto *hold = view.findChild<QSpinBox *>();
    const int before = hold->value();
    const auto stepUp = [&] {
        QTest::keyClick(hold, Qt::Key_Up);
        QCoreApplication::processEvents();
    };
    stepUp();
    stepUp();
    EXPECT_EQ(sequences().front().list.holdCycles, before + 2);
    EXPECT_EQ(document.undoStack().count(), 2) << "the words, the cycles";
    QTest::keyClick(hold, Qt::Key_Return);
    QCoreApplication::processEvents();
    stepUp();
    EXPECT_EQ(document.undoStack().count(), 3);
    document.undoStack().undo();
    EXPECT_EQ(sequences().front().list.holdCycles, before + 2);
}

TEST_F(ProjectSequencesTest, AnotherProjectBringsItsOwn)
{
    type({1});
    Project other;
    other.sequences.push_back({.name = QStringLiteral("reset"), .list = {.words = {9}, .holdCycles = 7}});
    document.setProject(other, {});
    EXPECT_EQ(view.list(), (WordList{.words = {9}, .holdCycles = 7}));
    EXPECT_EQ(names().currentText(), QStringLiteral("reset"));
    QCoreApplication::processEvents();
    EXPECT_TRUE(document.isSaved()) << "nothing was edited";
}

} // namespace
} // namespace codewheel
