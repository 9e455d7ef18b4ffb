// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "widgets/kinds/esc/line/esc_line_record_view.h"
#include "widgets/kinds/esc/line/replay_model.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QAccessible>
#include <QCheckBox>
#include <QDate>
#include <QDateTime>
#include <QPushButton>
#include <QTime>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Kind = esc::EscLineRow::Kind;
using test::wire;

EscLineRecord example()
{
    return {.begin = QDateTime(QDate(2026, 11, 20), QTime(9, 0)),
            .port = QStringLiteral("/dev/ttyUSB0"),
            .rows = {{{1ms, Kind::sent, wire("05P")}},
                     {{2ms, Kind::answer, "\r\n00001235\r\n"}},
                     {{3ms, Kind::sent, wire("05N")}, true},
                     {{4ms, Kind::answer, "\r\n00000001\r\n"}, true},
                     {{5ms, Kind::sent, wire("05GP00005200")}, true},
                     {{6ms, Kind::answer, "\r\n"}, true}}};
}

class EscLineRecordViewTest : public testing::Test
{
protected:
    EscLineRecordViewTest()
    {
        view.setLine(bench.line.get());
        view.showRecord(example(), QStringLiteral("a.json"));
        view.resize(900, 500);
        view.show();
    }
    void click(const char *text)
    {
        QPushButton *found = test::button(view, QLatin1String(text));
        ASSERT_NE(found, nullptr) << text;
        ASSERT_TRUE(found->isEnabled()) << text;
        found->click();
        bench.pass(1'000);
    }
    QString said() const
    {
        for (const auto *message : view.findChildren<InlineMessage *>())
            if (message->isVisible())
                return message->sentence();
        return {};
    }
    QStringList results() const
    {
        QStringList texts;
        const auto *steps = view.findChild<ReplayModel *>();
        for (int row = 0; row < steps->rowCount(); ++row)
            texts << steps->index(row, ReplayModel::result).data().toString();
        return texts;
    }

    test::EscLineBench bench;
    EscLineRecordView view;
    const test::ModelTester tester{*view.findChild<ReplayModel *>()};
};

TEST_F(EscLineRecordViewTest, WithoutALineItIsLookedAtOnly)
{
    QPushButton *replay = test::button(view, QStringLiteral("Replay"));
    EXPECT_FALSE(replay->isEnabled());
    EXPECT_EQ(QAccessible::queryAccessibleInterface(replay)->text(QAccessible::Description),
              replay->toolTip());
}

TEST_F(EscLineRecordViewTest, SendsReadsOnlyUnlessToldOtherwise)
{
    bench.open(EscLineSession::Start::operating);
    click("Replay");
    EXPECT_TRUE(bench.link->sent.empty());
    EXPECT_TRUE(said().startsWith(QLatin1String("1 of the 2 requests write to encoders: 05GP00005200")))
        << said().toStdString();
    EXPECT_EQ(results(), (QStringList{QStringLiteral("not sent"), QStringLiteral("not sent; writes")}));
    click("Send reads only");
    EXPECT_EQ(bench.link->sentTexts(), std::vector<QByteArray>{"05N"});
    EXPECT_EQ(results(), QStringList{QStringLiteral("differs")});
    EXPECT_TRUE(said().contains(QLatin1String("another: 1"))) << said().toStdString();
}

TEST_F(EscLineRecordViewTest, SendsWritesTooWhenThatIsAnswered)
{
    bench.open(EscLineSession::Start::operating);
    click("Replay");
    click("Send writes too");
    EXPECT_EQ(bench.link->sentTexts(), (std::vector<QByteArray>{"05N", "05GP00005200"}));
    EXPECT_EQ(results(), (QStringList{QStringLiteral("differs"), QStringLiteral("same")}));
}

TEST_F(EscLineRecordViewTest, InWatchWritesCannotBeChosen)
{
    bench.open();
    click("Replay");
    EXPECT_EQ(test::button(view, QStringLiteral("Send writes too")), nullptr);
    EXPECT_TRUE(said().contains(QLatin1String("only watches"))) << said().toStdString();
}

TEST_F(EscLineRecordViewTest, PollsAreSentWhenTheyAreShown)
{
    bench.open(EscLineSession::Start::operating);
    for (auto *box : view.findChildren<QCheckBox *>())
        if (plainLabel(box->text()) == QLatin1String("Hide automatic requests"))
            box->click();
    click("Replay");
    click("Send reads only");
    EXPECT_EQ(bench.link->sentTexts(), (std::vector<QByteArray>{"05P", "05N"}));
    EXPECT_EQ(results(), (QStringList{QStringLiteral("same"), QStringLiteral("differs")}));
}

TEST_F(EscLineRecordViewTest, CanBeCancelled)
{
    bench.open(EscLineSession::Start::operating);
    bench.link->answers.clear();
    click("Replay");
    test::button(view, QStringLiteral("Send writes too"))->click();
    bench.pass(10);
    test::button(view, QStringLiteral("Cancel"))->click();
    bench.pass(2'000);
    EXPECT_EQ(bench.link->sentTexts(), std::vector<QByteArray>{"05N"});
    EXPECT_TRUE(said().startsWith(QLatin1String("Cancelled."))) << said().toStdString();
}

TEST_F(EscLineRecordViewTest, EveryButtonHasATooltip)
{
    test::expectAccessible(view);
}

} // namespace
} // namespace codewheel
