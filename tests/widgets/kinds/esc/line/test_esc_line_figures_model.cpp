// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "widgets/kinds/esc/line/esc_line_figures_model.h"
#include "widgets/kinds/esc/line/esc_line_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTableView>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

EscLineSnapshot snapshot()
{
    EscLineSnapshot line;
    line.figures = {.requests = 1'000,
                    .answers = 990,
                    .timeOuts = 12,
                    .retries = 11,
                    .unanswered = 1,
                    .garbageBytes = 7,
                    .lateBytes = 10,
                    .answerTime = AnswerTime{5'100us, 6'200us, 31ms}};
    EscLineFigures ofOne;
    ofOne.requests = 4;
    line.devices.push_back({{.node = EscLineAddress{0x12}.node()}, ofOne});
    line.devices.push_back({{.node = EscLineAddress{3}.node(), .present = false}, {}});
    return line;
}

TEST(EscLineFiguresModel, ShowsTheLineAndEachEncoder)
{
    EscLineFiguresModel model;
    const test::ModelTester tester(model);
    model.show(snapshot());
    ASSERT_EQ(model.columnCount(), 2);
    EXPECT_EQ(model.headerData(1, Qt::Horizontal), QStringLiteral("12h (18)"));
    EXPECT_EQ(model.headerData(1, Qt::Horizontal, Qt::TextAlignmentRole),
              model.index(0, 1).data(Qt::TextAlignmentRole));
    QStringList line;
    for (int row = 0; row < model.rowCount(); ++row)
        line << model.index(row, 0).data().toString();
    EXPECT_EQ(line.mid(1).join(u' '), QStringLiteral("990 12 11 1 7 10 5.1 6.2 31.0"));
    EXPECT_EQ(model.index(0, 1).data(), QStringLiteral("4"));
    EXPECT_EQ(model.index(8, 1).data(), QStringLiteral("\u2013"));
}

TEST(EscLineFiguresModel, TellsOnlyWhatHasChanged)
{
    EscLineFiguresModel model;
    const test::ModelTester tester(model);
    EscLineSnapshot line = snapshot();
    model.show(line);
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    const QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    model.show(line);
    EXPECT_EQ(changed.count(), 0);
    ++line.devices.front().figures.answers;
    model.show(line);
    ASSERT_EQ(changed.count(), 1);
    EXPECT_EQ(changed.first().first().toModelIndex().column(), 1);
    EXPECT_EQ(reset.count(), 0);
}

class EscLinePanelTest : public testing::Test
{
protected:
    EscLinePanelTest()
    {
        panel.show();
        panel.setLine(bench.line.get());
    }
    QString value(const char *name) const
    {
        for (const auto *label : panel.findChildren<QLabel *>())
            if (label->accessibleName() == QLatin1String(name))
                return label->text();
        return QStringLiteral("no such line");
    }

    test::EscLineBench bench;
    EscLinePanel panel;
    RoleLabel &state = *panel.findChild<RoleLabel *>();
};

TEST_F(EscLinePanelTest, ShowsPortRateAndState)
{
    EXPECT_EQ(state.role(), Role::inactive);
    bench.open();
    EXPECT_EQ(state.role(), Role::running);
    EXPECT_EQ(value("Port"), QStringLiteral("scripted line"));
    EXPECT_TRUE(value("Baud rate").endsWith(QLatin1String("Bd, 8N2"))) << value("Baud rate").toStdString();
    EXPECT_EQ(value("Polling"), QStringLiteral("runs"));
    EXPECT_TRUE(value("Writing").startsWith(QLatin1String("Watch")));
    bench.line->setOperate(true);
    bench.line->setRunning(false);
    bench.pass(50);
    EXPECT_EQ(value("Polling"), QStringLiteral("stopped"));
    EXPECT_TRUE(value("Writing").startsWith(QLatin1String("Operate")));
}

TEST_F(EscLinePanelTest, SaysThatThePortIsGone)
{
    bench.open();
    bench.addEncoder();
    bench.link->unplugged = true;
    bench.pass(100);
    EXPECT_EQ(state.role(), Role::fault);
    EXPECT_TRUE(state.word().contains(QLatin1String("gone")));
}

TEST_F(EscLinePanelTest, SaysThatAnotherAdapterIsThere)
{
    bench.open();
    bench.addEncoder();
    bench.link->unplugged = true;
    bench.pass(100);
    bench.link->unplugged = false;
    bench.link->isOther = true;
    bench.pass(2'000);
    EXPECT_EQ(state.role(), Role::fault);
    EXPECT_TRUE(state.word().contains(QLatin1String("Another adapter"))) << state.word().toStdString();
    bench.line->takeOtherAdapter();
    bench.pass(100);
    EXPECT_EQ(state.role(), Role::running);
}

TEST_F(EscLinePanelTest, SaysWhatBecameOfLowLatency)
{
    bench.link->latency = LowLatency::refused;
    bench.open();
    bench.pass(100);
    EXPECT_TRUE(value("Low latency").startsWith(QLatin1String("refused")))
        << value("Low latency").toStdString();
}

TEST_F(EscLinePanelTest, ShowsTheFiguresOfEachEncoder)
{
    bench.open();
    bench.addEncoder();
    bench.pass(500);
    const QAbstractItemModel &figures = *panel.findChild<QTableView *>()->model();
    ASSERT_EQ(figures.columnCount(), 2);
    EXPECT_GT(figures.index(1, 1).data().toInt(), 10);
    panel.setLine(nullptr);
    EXPECT_EQ(figures.columnCount(), 1);
    EXPECT_EQ(state.role(), Role::inactive);
}

} // namespace
} // namespace codewheel
