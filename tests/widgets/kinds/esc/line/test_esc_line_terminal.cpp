// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/typed_request.h"
#include "tests/support/events_seen.h"
#include "tests/support/old_file.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/esc/line/request_field.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/trace/traffic_table.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFile>
#include <QIODevice>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

class EscLineTerminalTest : public testing::Test
{
protected:
    EscLineTerminalTest()
    {
        terminal.resize(900, 400);
        terminal.show();
        terminal.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&terminal));
        terminal.setLine(bench.line.get());
    }
    void type(const char *text)
    {
        field.setText(QLatin1String(text));
        QTest::keyClick(&field, Qt::Key_Return);
        bench.pass(300);
    }
    QString said() const
    {
        QStringList sentences;
        for (const auto *message : terminal.findChildren<InlineMessage *>())
            if (message->isVisible())
                sentences << message->sentence();
        return sentences.join(u'|');
    }
    static int columnOf(TrafficColumn column)
    {
        return static_cast<int>(std::ranges::find(lineTrafficColumns, column) - lineTrafficColumns.begin());
    }
    QString cell(int row, TrafficColumn column) const
    {
        return table.model()->index(row, columnOf(column)).data().toString();
    }
    QPushButton *button(const char *text) const { return test::button(terminal, QLatin1String(text)); }

    test::EscLineBench bench;
    EscLineTerminal terminal;
    RequestField &field = *terminal.findChild<RequestField *>();
    TrafficTable &table = *liveTable();

private:
    TrafficTable *liveTable() const
    {
        for (auto *found : terminal.findChildren<TrafficTable *>())
            if (found->accessibleName() == QLatin1String("Traffic on the line"))
                return found;
        return nullptr;
    }
};

TEST_F(EscLineTerminalTest, ATypedRequestAndItsAnswerAreSeenAmongThePolls)
{
    bench.open();
    bench.addEncoder();
    bench.pass(200);
    EXPECT_EQ(table.model()->rowCount(), 0);
    type("05p");
    ASSERT_EQ(table.model()->rowCount(), 2);
    EXPECT_EQ(cell(0, TrafficColumn::direction), QStringLiteral("sent, typed"));
    EXPECT_EQ(cell(1, TrafficColumn::meaning).remove(u','), QStringLiteral("1235h = 4661"));
    EXPECT_EQ(field.text(), QString());
    EXPECT_EQ(terminal.history(), QStringList{QStringLiteral("05P")});
}

TEST_F(EscLineTerminalTest, TheAnswerStaysWhenPollingPushesItsRowAway)
{
    bench.open();
    bench.addEncoder();
    for (auto *box : terminal.findChildren<QCheckBox *>())
        if (box->text() == QLatin1String("Hide automatic requests") && box->isVisible())
            box->click();
    const auto shown = [this] {
        for (const auto *line : terminal.findChildren<MeaningLine *>())
            if (line->isVisible() && line->text().startsWith(QLatin1String("05P: ")))
                return line->text().remove(u',');
        return QString();
    };
    EXPECT_EQ(shown(), QString());
    type("05p");
    bench.pass(5'000);
    EXPECT_GT(table.model()->rowCount(), 200);
    EXPECT_EQ(shown(), QStringLiteral("05P: 1235h = 4661"));
}

TEST_F(EscLineTerminalTest, ARowLeadsToItsEncoder)
{
    bench.open();
    bench.addEncoder();
    type("05P");
    std::vector<Place> places;
    QObject::connect(&terminal, &EscLineTerminal::goToWanted, [&](Place place) { places.push_back(place); });
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(1, 0)).center());
    QTest::keyClick(&table, Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(places, std::vector<Place>{bench.line->places().front()});
}

TEST_F(EscLineTerminalTest, WhatPassedWhileNobodyLookedIsThereWhenSomebodyDoes)
{
    bench.open();
    terminal.hide();
    field.setText(QStringLiteral("05P"));
    button("Send")->click();
    bench.pass(300);
    EXPECT_EQ(table.model()->rowCount(), 0) << "nobody sees them";
    terminal.show();
    EXPECT_TRUE(QTest::qWaitFor([this] { return table.model()->rowCount() == 2; }));
}

TEST_F(EscLineTerminalTest, RowsThatComeLayNothingOutAnew)
{
    bench.open();
    bench.line->send(*typedRequest(QStringLiteral("05P"), 0)); // brings up the page of rows
    bench.pass(300);
    QTest::qWait(50);
    const test::EventsSeen layouts(QEvent::LayoutRequest);
    bench.line->send(*typedRequest(QStringLiteral("05N"), 0));
    bench.pass(300);
    QCoreApplication::processEvents();
    EXPECT_EQ(table.model()->rowCount(), 4);
    EXPECT_EQ(layouts.text(), QString());
}

TEST_F(EscLineTerminalTest, ABadRequestIsRefusedOnTheSpot)
{
    bench.open();
    type("05Q");
    EXPECT_TRUE(said().contains(QLatin1String("There is no command \"Q\""))) << said().toStdString();
    EXPECT_TRUE(bench.link->sent.empty());
    EXPECT_EQ(field.text(), QStringLiteral("05Q"));
    QTest::keyClick(&field, Qt::Key_Backspace);
    EXPECT_EQ(said(), QString());
}

TEST_F(EscLineTerminalTest, AWriteIsRefusedInWatch)
{
    bench.open();
    type("05GP5200");
    EXPECT_TRUE(said().contains(QLatin1String("Operate"))) << said().toStdString();
    EXPECT_TRUE(bench.link->sent.empty());
}

TEST_F(EscLineTerminalTest, TheQuestionNamesWhoHasTheAddressAlready)
{
    bench.open(EscLineSession::Start::operating);
    bench.addEncoder();
    type("03X05");
    EXPECT_TRUE(said().contains(QLatin1String("Address 05h (5) is taken"))) << said().toStdString();
    type("05X05");
    EXPECT_FALSE(said().contains(QLatin1String("is taken"))) << "its own";
}

TEST_F(EscLineTerminalTest, AWriteIsAskedForWithItsBytes)
{
    bench.open(EscLineSession::Start::operating);
    type("05GP5200");
    EXPECT_TRUE(bench.link->sent.empty());
    EXPECT_TRUE(said().contains(QLatin1String("1B 30 35 47 50 30 30 30 30 35 32 30 30 0D 0A")))
        << said().toStdString();
    EXPECT_TRUE(said().contains(QLatin1String("The position becomes this value at once.")));
    EXPECT_TRUE(said().contains(QLatin1String("It costs one EEPROM write.")));
    button("Do not send")->click();
    EXPECT_EQ(said(), QString());
    EXPECT_TRUE(bench.link->sent.empty());

    QTest::keyClick(&field, Qt::Key_Return);
    button("Send and write")->click();
    bench.pass(300);
    EXPECT_EQ(bench.link->sentTexts(), std::vector<QByteArray>{"05GP00005200"});
    EXPECT_EQ(cell(1, TrafficColumn::meaning), QStringLiteral("accepted"));
}

TEST_F(EscLineTerminalTest, TheQuestionBeforeAPositionIsSetSaysWhichIsShownNow)
{
    bench.open(EscLineSession::Start::operating);
    bench.addEncoder();
    bench.pass(200);
    type("05GP5200");
    EXPECT_TRUE(said().endsWith(QStringLiteral("It shows %1 now.").arg(numberText(0x1235))))
        << said().toStdString();
    bench.link->answers[test::wire("05P")] = "\r\n00001300\r\n";
    bench.pass(200);
    EXPECT_TRUE(said().contains(QStringLiteral("It shows %1 now.").arg(numberText(0x1300))))
        << "while the question stands: " << said().toStdString();
    button("Do not send")->click();
    type("05GD1");
    EXPECT_FALSE(said().contains(QLatin1String("It shows"))) << said().toStdString();
}

TEST_F(EscLineTerminalTest, TheQuestionGoesWithOperateAndWithAlarmStop)
{
    bench.open(EscLineSession::Start::operating);
    type("05GP5200");
    bench.line->setOperate(false);
    bench.pass(20);
    EXPECT_EQ(button("Send and write"), nullptr);
    bench.line->setOperate(true);
    bench.pass(20);
    type("05GP5200");
    ASSERT_NE(button("Send and write"), nullptr);
    bench.line->alarmStop();
    EXPECT_EQ(button("Send and write"), nullptr);
}

TEST_F(EscLineTerminalTest, SaysWhenNoAnswerCame)
{
    bench.open(EscLineSession::Start::operating);
    type("03N");
    EXPECT_TRUE(said().startsWith(QLatin1String("No answer to 03N."))) << said().toStdString();
    type("03GP1");
    button("Send and write")->click();
    bench.pass(1'000);
    EXPECT_TRUE(said().contains(QLatin1String("unknown"))) << said().toStdString();
}

TEST_F(EscLineTerminalTest, WithoutALineNothingCanBeTyped)
{
    EXPECT_FALSE(field.isEnabled());
    EXPECT_TRUE(field.toolTip().contains(QLatin1String("not open"))) << field.toolTip().toStdString();
    bench.open();
    EXPECT_TRUE(field.isEnabled());
    bench.line->close();
    EXPECT_FALSE(field.isEnabled());
}

TEST_F(EscLineTerminalTest, PausedItHoldsTheTable)
{
    bench.open();
    test::action(terminal, QStringLiteral("Pause"))->trigger();
    type("05N");
    EXPECT_EQ(table.model()->rowCount(), 0);
    test::action(terminal, QStringLiteral("Pause"))->trigger();
    EXPECT_EQ(table.model()->rowCount(), 2);
}

TEST_F(EscLineTerminalTest, CopiesAndExportsWhatIsShown)
{
    bench.open();
    bench.addEncoder();
    type("05N");
    test::action(terminal, QStringLiteral("Copy"))->trigger();
    const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines.at(1).contains(QLatin1String("0BADCAFEh"))) << lines.at(1).toStdString();

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("line.txt"));
    ASSERT_TRUE(terminal.exportText(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    EXPECT_TRUE(text.startsWith(QLatin1String("2026-11-21T12:00:00."))) << text.toStdString();
    EXPECT_TRUE(
        text.contains(QStringLiteral("\t05: serial number?\t\u241B05N\u240D\u240A\t1B 30 35 4E 0D 0A")));
    EXPECT_FALSE(terminal.exportText(folder.filePath(QStringLiteral("no/such/line.txt"))));
    EXPECT_TRUE(said().contains(QLatin1String("was not saved")));
    test::OldFile old;
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &name) { return terminal.exportText(name); }));
    EXPECT_FALSE(old.saveWithoutRoom([&](const QString &name) { return terminal.save(name); }));
    EXPECT_TRUE(old.isThere());
    EXPECT_TRUE(said().endsWith(QLatin1String("File too large"))) << said().toStdString();
}

TEST_F(EscLineTerminalTest, ColumnsAreChosen)
{
    for (auto *box : terminal.findChildren<QCheckBox *>())
        if (plainLabel(box->text()) == QLatin1String("Hex") && box->isVisible())
            box->click();
    EXPECT_TRUE(table.isColumnHidden(columnOf(TrafficColumn::bytes)));
    EXPECT_FALSE(table.isColumnHidden(columnOf(TrafficColumn::text)));
}

TEST_F(EscLineTerminalTest, ASessionIsSavedWithItsPollsAndOpened)
{
    bench.open();
    bench.addEncoder();
    bench.pass(100);
    type("05N");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.json"));
    ASSERT_TRUE(terminal.save(path));
    ASSERT_TRUE(terminal.open(path));
    EXPECT_NE(button("Replay"), nullptr);
    EXPECT_FALSE(field.isVisible());
    button("Back to the line")->click();
    EXPECT_TRUE(field.isVisible());

    QFile broken(path);
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("{\n\"format\": 1}");
    broken.close();
    EXPECT_FALSE(terminal.open(path));
    EXPECT_TRUE(said().contains(QLatin1String("a.json, line 1"))) << said().toStdString();
}

TEST_F(EscLineTerminalTest, WhatWasCollectedOutlivesTheConnection)
{
    bench.open();
    type("05N");
    terminal.setLine(nullptr);
    EXPECT_EQ(table.model()->rowCount(), 2);
    bench.line.reset();
    EXPECT_EQ(cell(0, TrafficColumn::time).left(6), QStringLiteral("12:00:"));
}

TEST_F(EscLineTerminalTest, EveryButtonHasATooltip)
{
    test::expectAccessible(terminal);
}

TEST_F(EscLineTerminalTest, WhatWasClearedIsBroughtBackWithItsTimes)
{
    bench.open();
    type("05N");
    const int rows = table.model()->rowCount();
    ASSERT_GT(rows, 0);
    const QString first = cell(0, TrafficColumn::time);
    QAction *bringBack = test::action(terminal, QStringLiteral("Bring back"));
    ASSERT_TRUE(bringBack);
    EXPECT_FALSE(bringBack->isEnabled());
    test::action(terminal, QStringLiteral("Clear"))->trigger();
    EXPECT_EQ(table.model()->rowCount(), 0);
    type("05V");
    const int since = table.model()->rowCount();
    ASSERT_TRUE(bringBack->isEnabled());
    bringBack->trigger();
    EXPECT_EQ(table.model()->rowCount(), rows + since);
    EXPECT_EQ(cell(0, TrafficColumn::time), first);
    EXPECT_FALSE(bringBack->isEnabled());
}

} // namespace
} // namespace codewheel
