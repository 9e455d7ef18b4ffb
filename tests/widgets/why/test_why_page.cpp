// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"
#include "widgets/why/data_check_model.h"
#include "widgets/why/why_page.h"

#include <QCoreApplication>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using StepId = DataCheck::Id;
using StepAction = DataCheck::Action;

DataCheck linkStep()
{
    return DataStep{StepId::link, QStringLiteral("Link"), QStringLiteral("connected")}.passed();
}

DataCheck positionStep(const QString &came)
{
    return DataStep{StepId::position, QStringLiteral("Position"), QStringLiteral("valid")}.passed(came);
}

DataCheck stoppedStep()
{
    return DataStep{StepId::running, QStringLiteral("Ring"), QStringLiteral("runs")}.failed(
        QStringLiteral("READY"), QStringLiteral("Start it."), StepAction::start);
}

DataCheck watchingStep()
{
    const DataStep step{StepId::writing, QStringLiteral("Writing"), QStringLiteral("as you want it")};
    return step.remark(QStringLiteral("Watch"), QStringLiteral("Switch to Operate to write."),
                       StepAction::operate);
}

class WhyPageTest : public testing::Test
{
protected:
    WhyPageTest()
    {
        page.resize(600, 400);
        page.show();
    }
    InlineMessage &help() { return *page.findChild<InlineMessage *>(QStringLiteral("whyHelp")); }
    QString outcome() { return page.findChild<RoleLabel *>()->word(); }
    QTableView &table() { return *page.findChild<QTableView *>(); }
    QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
    QString spoken(int row) { return table().model()->index(row, 0).data(Qt::AccessibleTextRole).toString(); }

    QString button = QStringLiteral("Start");
    int lookups = 0;
    WhyPage page{
        {.troubleOf =
             [this](const Refusal &) {
                 ++lookups;
                 return Trouble(QStringLiteral("You may not use the port."), QStringLiteral("usermod"));
             },
         .buttonFor = [this](StepAction action) { return action == StepAction::none ? QString() : button; }}};
};

TEST_F(WhyPageTest, NamesWhatDiffersFirstAndWhatToDo)
{
    page.showChecks(QStringLiteral("3.0"),
                    asFarAsKnown({linkStep(), stoppedStep(), positionStep(QStringLiteral("12"))}));
    EXPECT_EQ(page.about(), QStringLiteral("3.0"));
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Ring"));
    EXPECT_EQ(help().sentence(), QStringLiteral("Start it."));
    EXPECT_TRUE(help().isVisible());
    EXPECT_EQ(cell(1, 1), QStringLiteral("runs"));
    EXPECT_EQ(cell(1, 2), QStringLiteral("READY"));
    EXPECT_EQ(cell(2, 2), QString(QChar(0x2013))) << "not known";
    EXPECT_EQ(spoken(0), QStringLiteral("Link: as expected"));
    EXPECT_EQ(spoken(1), QStringLiteral("Ring: differs"));
    EXPECT_EQ(spoken(2), QStringLiteral("Position: not known"));
}

TEST_F(WhyPageTest, SaysThatAllIsAsExpectedWithThePosition)
{
    page.showChecks(QStringLiteral("3.0"), {linkStep(), positionStep(QStringLiteral("12,345"))});
    EXPECT_EQ(outcome(), QStringLiteral("Everything is as expected. Position: 12,345"));
    EXPECT_FALSE(help().isVisible());
    page.showChecks(QStringLiteral("3.0"),
                    {linkStep(), positionStep(QStringLiteral("12,345")), watchingStep()});
    EXPECT_EQ(outcome(), QStringLiteral("Data comes. Position: 12,345"));
    EXPECT_EQ(help().sentence(), QStringLiteral("Switch to Operate to write.")) << "worth knowing";
    EXPECT_EQ(spoken(2), QStringLiteral("Writing: worth knowing"));
}

TEST_F(WhyPageTest, AnUncertainPositionIsNoGoodNews)
{
    const auto role = [this] { return page.findChild<RoleLabel *>()->role(); };
    DataCheck position = positionStep(QStringLiteral("0, or no supply"));
    page.showChecks(QStringLiteral("3.0"), {linkStep(), position, watchingStep()});
    EXPECT_EQ(role(), Role::running);
    position.outcome = DataCheck::Outcome::remark;
    page.showChecks(QStringLiteral("3.0"), {linkStep(), position, watchingStep()});
    EXPECT_EQ(role(), Role::attention);
    EXPECT_EQ(outcome(), QStringLiteral("Data comes. Position: 0, or no supply"));
}

TEST_F(WhyPageTest, ItsButtonAsksForTheActionAndIsThereOnlyWhileThatIsPossible)
{
    QSignalSpy wanted(&page, &WhyPage::actionWanted);
    button.clear();
    page.showChecks({}, {linkStep(), stoppedStep()});
    const auto shown = [this] {
        for (auto *each : help().findChildren<QPushButton *>())
            if (each->isVisible())
                return each;
        return static_cast<QPushButton *>(nullptr);
    };
    EXPECT_EQ(shown(), nullptr);
    button = QStringLiteral("Start");
    page.showChecks({}, {linkStep(), stoppedStep()});
    ASSERT_NE(shown(), nullptr);
    EXPECT_EQ(shown()->text(), button);
    EXPECT_FALSE(shown()->toolTip().isEmpty());
    QTest::mouseClick(shown(), Qt::LeftButton);
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_EQ(wanted.front().front().value<StepAction>(), StepAction::start);
}

TEST_F(WhyPageTest, TellsWhatTheComputerKnowsAndLooksOnlyOnce)
{
    const DataStep step{StepId::link, QStringLiteral("Link"), QStringLiteral("/dev/ttyUSB0")};
    DataCheck refused =
        step.failed(QStringLiteral("not connected"), QStringLiteral("No."), StepAction::connection);
    refused.why = Refusal{RefusalKind::link, RefusalId::portNotFound, {QStringLiteral("/dev/ttyUSB0")}};
    for (int frame = 0; frame < 3; ++frame)
        page.showChecks({}, {refused});
    EXPECT_EQ(help().sentence(), QStringLiteral("You may not use the port."));
    EXPECT_EQ(help().command(), QStringLiteral("usermod"));
    EXPECT_EQ(lookups, 1);
}

TEST_F(WhyPageTest, RefreshesOnlyTheRowsThatHaveChanged)
{
    page.showChecks({}, {linkStep(), positionStep(QStringLiteral("1"))});
    table().selectRow(0);
    const QSignalSpy reset(table().model(), &QAbstractItemModel::modelReset);
    const QSignalSpy changed(table().model(), &QAbstractItemModel::dataChanged);
    page.showChecks({}, {linkStep(), positionStep(QStringLiteral("1"))});
    EXPECT_EQ(changed.count(), 0);
    page.showChecks({}, {linkStep(), positionStep(QStringLiteral("2"))});
    ASSERT_EQ(changed.count(), 1);
    EXPECT_EQ(changed.front().front().toModelIndex().row(), 1);
    EXPECT_EQ(reset.count(), 0);
    EXPECT_TRUE(table().selectionModel()->isRowSelected(0));
}

TEST_F(WhyPageTest, AMessageThatWasClosedComesAgainForAnotherDevice)
{
    page.showChecks(QStringLiteral("3.0"), {linkStep(), stoppedStep()});
    help().withdraw();
    page.showChecks(QStringLiteral("3.0"), {linkStep(), stoppedStep()});
    EXPECT_FALSE(help().isVisible());
    page.showChecks(QStringLiteral("4.0"), {linkStep(), stoppedStep()});
    EXPECT_TRUE(help().isVisible());
}

TEST_F(WhyPageTest, CountsInTheMessageGoOnAndOneThatWasClosedStaysClosed)
{
    DataCheck noise = stoppedStep();
    noise.remedy = QStringLiteral("9 bytes came. Check the rate.");
    page.showChecks({}, {noise});
    noise.remedy = QStringLiteral("10 bytes came. Check the rate.");
    page.showChecks({}, {noise});
    EXPECT_EQ(help().sentence(), noise.remedy);
    help().withdraw();
    noise.remedy = QStringLiteral("11 bytes came. Check the rate.");
    page.showChecks({}, {noise});
    EXPECT_FALSE(help().isVisible());
    noise.remedy = QStringLiteral("Nothing comes any more.");
    page.showChecks({}, {noise});
    EXPECT_TRUE(help().isVisible()) << "it is another message";
}

TEST_F(WhyPageTest, LongTextsTakeMoreLines)
{
    page.showChecks({}, {linkStep()});
    QCoreApplication::processEvents();
    const int before = table().rowHeight(0);
    DataCheck longer = linkStep();
    longer.came = QStringLiteral("a text that needs more than one line ").repeated(4);
    page.showChecks({}, {longer});
    QCoreApplication::processEvents();
    EXPECT_GT(table().rowHeight(0), before);
}

TEST_F(WhyPageTest, WithoutAChosenRowSaysWhatToDo)
{
    page.showChecks({}, {});
    EXPECT_TRUE(page.findChild<EmptyState *>()->isVisible());
    EXPECT_FALSE(table().isVisible());
    EXPECT_FALSE(help().isVisible());
}

TEST_F(WhyPageTest, TheStepThatDiffersFirstIsSelectedUntilTheUserChoosesAnother)
{
    const auto selected = [this] {
        const auto rows = table().selectionModel()->selectedRows();
        return rows.isEmpty() ? -1 : rows.front().row();
    };
    page.showChecks(QStringLiteral("Ring"), {linkStep(), stoppedStep(), positionStep(QString())});
    EXPECT_EQ(selected(), 1);
    table().selectRow(0);
    page.showChecks(QStringLiteral("Ring"), {linkStep(), stoppedStep(), positionStep(QString())});
    EXPECT_EQ(selected(), 0);
}

} // namespace
} // namespace codewheel
