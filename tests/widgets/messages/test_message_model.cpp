// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "tests/support/model_tester.h"
#include "tests/widgets/training_bus_session.h"
#include "vocabulary/refusal_text.h"
#include "widgets/messages/message_model.h"

#include <QAbstractItemModel>
#include <QDate>
#include <QDateTime>
#include <QIcon>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <QTime>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

const QDateTime noon(QDate(2026, 3, 1), QTime(12, 0));

Message training(const char *what, std::optional<Place> place = {})
{
    return {.place = place, .id = MessageId::training, .arguments = {QString::fromUtf8(what)}};
}

QString shown(const QAbstractItemModel &model, int row, int column)
{
    return model.index(row, column).data().toString();
}

// Without the rows for days.
QStringList texts(const MessageModel &messages)
{
    QStringList all;
    for (int row = 0; row < messages.rowCount(); ++row)
        if (!messages.isDay(row))
            all << shown(messages, row, MessageModel::textColumn);
    return all;
}

TEST(MessageModel, ShowsTimeSeverityPlaceAndText)
{
    MessageStore store({});
    MessageModel messages(store);
    const test::ModelTester tester(messages);
    messages.add({.place = fraba,
                  .severity = Severity::fault,
                  .id = MessageId::deviceFault,
                  .arguments = {std::int64_t{3}, Word{0x86000000}}},
                 noon.addMSecs(7));
    messages.catchUp();
    ASSERT_EQ(messages.rowCount(), 2);
    EXPECT_TRUE(messages.isDay(0));
    EXPECT_EQ(shown(messages, 0, 0), QLocale().toString(noon.date(), QLocale::LongFormat));
    EXPECT_EQ(shown(messages, 1, MessageModel::timeColumn), QStringLiteral("12:00:00"));
    EXPECT_TRUE(messages.index(1, MessageModel::timeColumn)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .endsWith(QStringLiteral("26 12:00:00.007")));
    EXPECT_EQ(shown(messages, 1, MessageModel::severityColumn), QStringLiteral("Fault"));
    EXPECT_EQ(shown(messages, 1, MessageModel::placeColumn), QStringLiteral("1.0"));
    EXPECT_EQ(shown(messages, 1, MessageModel::textColumn),
              QStringLiteral("The encoder reports error 3 (IN 86000000)."));
    EXPECT_FALSE(
        messages.index(1, MessageModel::severityColumn).data(Qt::DecorationRole).value<QIcon>().isNull());
}

TEST(MessageModel, StampsWhatHappensNowWithTheTimeOfTheBus)
{
    test::TrainingBusSession ring;
    MessageStore store({});
    MessageModel messages(store);
    messages.setClock(ring.bus);
    ring.bus.advance(90);
    messages.addNow(training("power off", baumer));
    messages.catchUp();
    EXPECT_EQ(messages.message(1).at, ring.bus.dateTime(ring.bus.latest().at).toMSecsSinceEpoch());
}

TEST(MessageModel, ShowsWhatIsOnDiskFromBefore)
{
    const QTemporaryDir folder;
    const MessageStore::Settings file{.file = folder.filePath(QStringLiteral("messages.sqlite"))};
    {
        MessageStore store(file);
        store.add(training("yesterday"), noon.addDays(-1));
    }
    MessageStore store(file);
    MessageModel messages(store);
    messages.add(training("today"), noon);
    messages.catchUp();
    EXPECT_EQ(texts(messages), (QStringList{QStringLiteral("yesterday"), QStringLiteral("today")}));
    ASSERT_EQ(messages.rowCount(), 4);
    EXPECT_TRUE(messages.isDay(0));
    EXPECT_TRUE(messages.isDay(2));
}

TEST(MessageModel, ShowsWhatTheStoreKeepsByItself)
{
    MessageStore store({});
    MessageModel messages(store);
    messages.add(training("something"), noon);
    EXPECT_TRUE(QTest::qWaitFor([&] { return messages.rowCount() == 2; }, 60'000));
}

TEST(MessageModel, FollowsTheStoreWhenItDropsTheOldest)
{
    const QTemporaryDir folder;
    MessageStore store({.file = folder.filePath(QStringLiteral("messages.sqlite")), .largestSize = 200'000});
    MessageModel messages(store);
    const test::ModelTester tester(messages);
    for (int i = 0; i < 5'000; ++i)
        messages.add(training(i % 2 == 0 ? "old, and with some text to take room" : "other"), noon);
    for (int i = 0; i < 30; ++i) {
        messages.add(training("newest"), noon);
        messages.catchUp();
    }
    EXPECT_LT(messages.rowCount(), 4'000);
    EXPECT_GT(messages.rowCount(), 500);
    EXPECT_TRUE(messages.isDay(0));
    EXPECT_FALSE(shown(messages, 1, MessageModel::textColumn).isEmpty());
}

TEST(MessageModel, StaysFluentWithManyRowsByFetchingThem)
{
    MessageStore store({});
    MessageModel messages(store);
    const test::ModelTester tester(messages);
    for (int i = 0; i < 20'000; ++i)
        messages.add(training(i % 2 == 0 ? "tick" : "tock"), noon.addMSecs(100 * i));
    messages.catchUp();
    ASSERT_EQ(messages.rowCount(), 20'001);
    EXPECT_EQ(shown(messages, 20'000, MessageModel::textColumn), QStringLiteral("tock"));
    EXPECT_EQ(shown(messages, 10'001, MessageModel::timeColumn), QStringLiteral("12:16:40"));
    EXPECT_EQ(shown(messages, 1, MessageModel::timeColumn), QStringLiteral("12:00:00"));
}

TEST(MessageModel, WhatRepeatsIsOneRowWithItsCount)
{
    MessageStore store({});
    MessageModel messages(store);
    const test::ModelTester tester(messages);
    const auto errors = [&](std::int64_t more, std::int64_t all, int second) {
        messages.add({.severity = Severity::attention,
                      .id = MessageId::crcErrors,
                      .arguments = {std::int64_t{3}, more, all}},
                     noon.addSecs(second));
        messages.catchUp();
    };
    errors(179, 179, 5);
    errors(3, 182, 65);
    ASSERT_EQ(messages.rowCount(), 2);
    EXPECT_EQ(messages.countOf(1), 2);
    EXPECT_EQ(messages.idsOf(1).size(), 2U);
    EXPECT_EQ(shown(messages, 1, MessageModel::timeColumn), QStringLiteral("12:01:05"));
    const QString text = shown(messages, 1, MessageModel::textColumn);
    EXPECT_TRUE(text.contains(QStringLiteral("182"))) << text.toStdString();
    EXPECT_TRUE(text.endsWith(QStringLiteral(" (2 times since 12:00:05)"))) << text.toStdString();
    messages.add(training("between"), noon.addSecs(66));
    errors(1, 183, 67);
    EXPECT_EQ(messages.rowCount(), 4);
}

TEST(MessageModel, RowsAreTheSameWhetherTheyCameOrWereFound)
{
    MessageStore store({});
    MessageModel came(store);
    came.catchUp();
    const test::ModelTester tester(came);
    for (int i = 0; i < 9'000; ++i) {
        came.add(training(i % 7 < 3 ? "again" : i % 7 == 3 ? "once" : "more"), noon.addSecs(30 * i));
        if (i % 500 == 0)
            came.catchUp();
    }
    came.catchUp();
    MessageModel found(store);
    const test::ModelTester findTester(found);
    found.catchUp();
    EXPECT_EQ(texts(found), texts(came));
    EXPECT_EQ(found.rowCount(), came.rowCount());
    EXPECT_EQ(found.ids().size(), 9'000);
}

TEST(MessageModel, CountsWhatWasNotSeen)
{
    MessageStore store({});
    MessageModel messages(store);
    messages.add(training("information"), noon);
    EXPECT_EQ(messages.unseen(), 0);
    messages.add({.severity = Severity::attention, .id = RingMessageId::alarmStop}, noon);
    messages.add({.severity = Severity::fault, .id = EscMessageId::portLost}, noon);
    EXPECT_EQ(messages.unseen(), 2);
    messages.see();
    EXPECT_EQ(messages.unseen(), 0);
}

TEST(MessageModel, HidesWhatIsClearedAndBringsItBack)
{
    MessageStore store({});
    MessageModel messages(store);
    const test::ModelTester tester(messages);
    messages.add(training("before"), noon);
    messages.catchUp();
    messages.clear();
    EXPECT_EQ(messages.rowCount(), 0);
    EXPECT_TRUE(messages.isEmpty());
    messages.add(training("after"), noon);
    messages.catchUp();
    EXPECT_EQ(texts(messages), QStringList{QStringLiteral("after")});
    messages.bringBack();
    EXPECT_EQ(texts(messages).size(), 2);
}

class MessageFilterTest : public testing::Test
{
protected:
    MessageFilterTest()
    {
        messages.add({.severity = Severity::information, .id = MessageId::busStarted}, noon);
        messages.add(training("Power off", fraba), noon.addSecs(60));
        messages.add({.place = baumer, .severity = Severity::fault, .id = MessageId::deviceFaultGone},
                     noon.addSecs(120));
        messages.catchUp();
    }
    int count(const MessageFilter &filter)
    {
        messages.setFilter(filter);
        messages.catchUp();
        EXPECT_EQ(messages.searched(), std::nullopt);
        return static_cast<int>(texts(messages).size());
    }

    MessageStore store{{}};
    MessageModel messages{store};
    test::ModelTester tester{messages};
};

TEST_F(MessageFilterTest, ShowsEverythingAtFirst)
{
    EXPECT_EQ(texts(messages).size(), 3);
}

TEST_F(MessageFilterTest, KeepsASeverityAndWorse)
{
    ASSERT_EQ(count({.least = Severity::attention}), 1);
    EXPECT_EQ(shown(messages, 1, MessageModel::placeColumn), QStringLiteral("2.0"));
    messages.add({.severity = Severity::attention, .id = MessageId::lateCycles}, noon);
    messages.add({.id = MessageId::busStopped}, noon);
    messages.catchUp();
    EXPECT_EQ(texts(messages).size(), 2);
}

TEST_F(MessageFilterTest, KeepsAPlaceOrTheBus)
{
    ASSERT_EQ(count({.place = {.all = false, .at = fraba}}), 1);
    EXPECT_EQ(shown(messages, 1, MessageModel::textColumn), QStringLiteral("Power off"));
    ASSERT_EQ(count({.place = {.all = false}}), 1);
    EXPECT_EQ(shown(messages, 1, MessageModel::textColumn), QStringLiteral("The bus runs."));
}

TEST_F(MessageFilterTest, KeepsATime)
{
    const qint64 second = noon.addSecs(60).toMSecsSinceEpoch();
    EXPECT_EQ(count({.from = second}), 2);
    EXPECT_EQ(count({.until = second}), 1);
    EXPECT_EQ(count({.from = second, .until = second + 1}), 1);
}

TEST_F(MessageFilterTest, FindsTextInAnyColumnInAnyCase)
{
    EXPECT_EQ(count({.text = QStringLiteral("POWER")}), 1);
    EXPECT_EQ(count({.text = QStringLiteral("2.0")}), 1);
    EXPECT_EQ(count({.text = QStringLiteral("12:01")}), 1);
    EXPECT_EQ(count({.text = QStringLiteral("nowhere")}), 0);
}

TEST_F(MessageFilterTest, TakesNewMessagesThatFitTheText)
{
    EXPECT_EQ(count({.text = QStringLiteral("power")}), 1);
    messages.add(training("Power on", fraba), noon);
    messages.add(training("Speed", fraba), noon);
    messages.catchUp();
    EXPECT_EQ(texts(messages).size(), 2);
    EXPECT_EQ(texts(messages).back(), QStringLiteral("Power on"));
}

} // namespace
} // namespace codewheel
