// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_traffic.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/traffic/can_traffic_view.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/trace/traffic_table.h"

#include <QAction>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanTrafficViewTest : public test::CanopenPlant
{
protected:
    CanTrafficViewTest()
    {
        view.resize(900, 500);
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
        view.setBus(bus.get());
    }
    void pass(Instant time)
    {
        bus->advance(time);
        QCoreApplication::processEvents();
    }
    QStringList meanings() const
    {
        QStringList texts;
        const int column = static_cast<int>(std::ranges::find(canTrafficColumns, TrafficColumn::meaning) -
                                            canTrafficColumns.begin());
        for (int row = 0; row < table->model()->rowCount(); ++row)
            texts << table->model()->index(row, column).data().toString();
        return texts;
    }
    void choose(const char *text) const
    {
        for (QAction *action :
             view.findChild<QToolButton *>(QStringLiteral("canTrafficRows"))->menu()->actions())
            if (action->text() == QLatin1String(text))
                return action->trigger();
        FAIL() << text;
    }
    void type(const char *frame)
    {
        field->setFocus();
        field->clear();
        QTest::keyClicks(field, QLatin1String(frame));
        QTest::keyClick(field, Qt::Key_Return);
    }
    QString said() const
    {
        QStringList sentences;
        for (const auto *message : view.findChildren<InlineMessage *>())
            if (message->isVisible())
                sentences << message->sentence();
        return sentences.join(u'|');
    }
    QPushButton *button(const QString &text) const
    {
        for (auto *found : view.findChildren<QPushButton *>())
            if (found->text() == text && found->isVisible())
                return found;
        return nullptr;
    }

    CanTrafficView view;
    TrafficTable *table = view.findChild<TrafficTable *>();
    QLineEdit *field = view.findChild<QLineEdit *>(QStringLiteral("canFrameToSend"));
    QLineEdit *filter = view.findChild<QLineEdit *>(QStringLiteral("canTrafficText"));
};

TEST_F(CanTrafficViewTest, ATransferIsOneRowOrItsFrames)
{
    operate();
    pass(100ms);
    filter->setText(QStringLiteral("6502h"));
    const auto before = meanings().size();
    bus->transfer({.node = 5, .object = {0x6502, 0}});
    pass(200ms);
    ASSERT_EQ(meanings().size(), before + 1);
    EXPECT_TRUE(meanings().last().startsWith(QStringLiteral("Node 5: read 6502h:0 = ")))
        << meanings().last().toStdString();
    EXPECT_TRUE(meanings().last().endsWith(QStringLiteral(" ms)"))) << meanings().last().toStdString();
    choose("A transfer as one row");
    ASSERT_GE(meanings().size(), 2);
    EXPECT_EQ(meanings().at(meanings().size() - 2), QStringLiteral("Node 5: read 6502h:0"));
    EXPECT_FALSE(meanings().last().endsWith(QStringLiteral(" ms)")));
}

TEST_F(CanTrafficViewTest, WhereAnotherConnectionBeginsIsSeenUnderEachFilter)
{
    view.setMostRows(100);
    operate();
    pass(20s);
    EXPECT_TRUE(std::ranges::any_of(view.findChildren<QLabel *>(), [](const QLabel *each) {
        return each->text().endsWith(QStringLiteral(" older ones not kept"));
    }));
    view.setBus(nullptr);
    view.setBus(bus.get());
    filter->setText(QStringLiteral("can:6"));
    EXPECT_EQ(meanings().last(), QStringLiteral("Another connection begins here."));
    pass(3s);
    EXPECT_GT(meanings().indexOf(QStringLiteral("Another connection begins here.")), 0);
    EXPECT_NE(meanings().last(), QStringLiteral("Another connection begins here."));
}

TEST_F(CanTrafficViewTest, ServicesAreHiddenAndShown)
{
    operate();
    say(test::canFrame(0x185, {0x88, 0x13, 0, 0}));
    pass(100ms);
    ASSERT_FALSE(meanings().filter(QStringLiteral("TPDO")).isEmpty());
    ASSERT_FALSE(meanings().filter(QStringLiteral("boot-up")).isEmpty());
    choose("Process data (PDO)");
    EXPECT_TRUE(meanings().filter(QStringLiteral("TPDO")).isEmpty());
    EXPECT_FALSE(meanings().filter(QStringLiteral("boot-up")).isEmpty());
    choose("Process data (PDO)");
    EXPECT_FALSE(meanings().filter(QStringLiteral("TPDO")).isEmpty());
    choose("What comes again and again (PDO, SYNC, polling)");
    EXPECT_TRUE(meanings().filter(QStringLiteral("TPDO")).isEmpty());
    EXPECT_FALSE(meanings().filter(QStringLiteral("boot-up")).isEmpty());
    filter->setText(QStringLiteral("can:6"));
    EXPECT_FALSE(meanings().isEmpty());
    for (const QString &meaning : meanings())
        EXPECT_TRUE(meaning.startsWith(QStringLiteral("Node 6:"))) << meaning.toStdString();
}

TEST_F(CanTrafficViewTest, ProcessDataHaveTheirValues)
{
    operate();
    say(test::canFrame(0x185, {0x88, 0x13, 0, 0}));
    pass(100ms);
    EXPECT_FALSE(meanings().filter(QStringLiteral("Node 5: TPDO1, 6004h:0 = 1388h = 5000")).isEmpty());
}

TEST_F(CanTrafficViewTest, AReadIsSentAtOnceAndSeen)
{
    operate();
    filter->setText(QStringLiteral("6503h"));
    const auto before = meanings().size();
    type("605#4003650000000000");
    pass(200ms);
    EXPECT_EQ(said(), QString());
    EXPECT_EQ(meanings().size(), before + 1);
}

TEST_F(CanTrafficViewTest, AnythingElseIsAskedFor)
{
    operate();
    const auto sent = [&] { return sentTo(0x000); };
    const int before = sent();
    type("000#0205");
    pass(200ms);
    EXPECT_EQ(sent(), before);
    EXPECT_EQ(said(), QStringLiteral("This is sent: NMT: stop node 5. A drive may move."));
    ASSERT_NE(button(QStringLiteral("Do &not send")), nullptr);
    QTest::qWait(QApplication::doubleClickInterval());
    QTest::mouseClick(button(QStringLiteral("Do &not send")), Qt::LeftButton);
    pass(200ms);
    EXPECT_EQ(sent(), before);
    type("000#0205");
    QTest::qWait(QApplication::doubleClickInterval());
    QTest::mouseClick(button(QStringLiteral("&Send it")), Qt::LeftButton);
    pass(200ms);
    EXPECT_EQ(sent(), before + 1);
    EXPECT_EQ(stateOf(0), canopen::NmtState::stopped);
    type("605#2310100173617665");
    EXPECT_TRUE(said().endsWith(QStringLiteral("It costs an EEPROM write."))) << said().toStdString();
}

TEST_F(CanTrafficViewTest, WhatTheAdapterDoesNotTellIsSaid)
{
    operate();
    link->tellsFates = false;
    type("605#4003650000000000");
    pass(200ms);
    EXPECT_TRUE(said().startsWith(QStringLiteral("Whether the frame has gone out is not known")))
        << said().toStdString();
}

TEST_F(CanTrafficViewTest, InWatchAndFromARecordingNothingIsSent)
{
    open(EncoderBus::Start::watching);
    pass(1s);
    link->sent.clear();
    type("605#4003650000000000");
    pass(200ms);
    EXPECT_TRUE(link->sent.empty());
    EXPECT_TRUE(said().contains(QStringLiteral("only watches"))) << said().toStdString();
    bus->setOperate(true);
    pass(200ms);
    view.setRecordingChosen(true);
    link->sent.clear();
    type("000#0105");
    pass(200ms);
    EXPECT_EQ(sentTo(0x000), 0);
    EXPECT_FALSE(button(QStringLiteral("&Send it")));
}

TEST_F(CanTrafficViewTest, WhatIsNoFrameIsSaidSo)
{
    operate();
    for (const char *text : {"605", "605#4", "60#40", "605#400000000000000000", "20000080#00"}) {
        type(text);
        EXPECT_TRUE(said().startsWith(QStringLiteral("Nothing was sent."))) << text;
        EXPECT_EQ(field->text(), QLatin1String(text));
    }
    type("605 # 40 03 65 00 00 00 00 00");
    EXPECT_EQ(said(), QString());
    EXPECT_EQ(view.findChild<MeaningLine *>()->text(), QStringLiteral("Node 5: read 6503h:0"));
}

TEST_F(CanTrafficViewTest, RowsOutliveTheConnectionAndAreExported)
{
    operate();
    pass(100ms);
    const auto rows = meanings().size();
    bus.reset();
    EXPECT_EQ(meanings().size(), rows);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("can.txt"));
    ASSERT_TRUE(view.exportTo(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().count('\n'), rows);
    EXPECT_FALSE(view.exportTo(folder.filePath(QStringLiteral("no/can.txt"))));
    EXPECT_TRUE(said().contains(QStringLiteral("was not saved"))) << said().toStdString();
}

} // namespace
} // namespace codewheel
