// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/refusal_text.h"
#include "tests/support/model_tester.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/messages/message_filter.h"
#include "widgets/messages/message_model.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

const QDateTime noon(QDate(2026, 3, 1), QTime(12, 0));

Message training(const char *what, std::optional<DeviceNumber> place = {})
{
    return {.place = place, .id = MessageId::training, .arguments = {QString::fromUtf8(what)}};
}

QString shown(const QAbstractItemModel &model, int row, int column)
{
    return model.index(row, column).data().toString();
}

TEST(MessageModel, ShowsTimeSeverityPlaceAndText)
{
    MessageModel messages;
    const test::ModelTester tester(messages);
    messages.add({.place = fraba,
                  .severity = Severity::fault,
                  .id = MessageId::deviceFault,
                  .arguments = {std::int64_t{3}, Word{0x86000000}}},
                 noon.addMSecs(7));
    ASSERT_EQ(messages.rowCount(), 1);
    EXPECT_TRUE(shown(messages, 0, MessageModel::timeColumn).endsWith(QStringLiteral("12:00:00.007")));
    EXPECT_EQ(shown(messages, 0, MessageModel::severityColumn), QStringLiteral("Fault"));
    EXPECT_EQ(shown(messages, 0, MessageModel::placeColumn), QStringLiteral("1.0"));
    EXPECT_EQ(shown(messages, 0, MessageModel::textColumn),
              QStringLiteral("The encoder reports error 3 (IN 86000000)."));
    EXPECT_FALSE(
        messages.index(0, MessageModel::severityColumn).data(Qt::DecorationRole).value<QIcon>().isNull());
}

TEST(MessageModel, TakesTheMessagesOfTheBusWithItsTime)
{
    test::TrainingBusSession ring;
    MessageModel messages;
    const test::ModelTester tester(messages);
    messages.setBus(ring.bus);
    ring.bus.setOperate(false);
    ring.bus.advance(5);
    ASSERT_EQ(messages.rowCount(), 1);
    EXPECT_EQ(messages.rowAt(0).message.id, MessageId::watchOn);
    EXPECT_EQ(messages.rowAt(0).at, ring.bus.dateTime(messages.rowAt(0).message.at));
    EXPECT_EQ(shown(messages, 0, MessageModel::placeColumn), QStringLiteral("Bus"));
}

TEST(MessageModel, StampsWhatHappensNowWithTheTimeOfTheBus)
{
    test::TrainingBusSession ring;
    MessageModel messages;
    messages.setBus(ring.bus);
    ring.bus.advance(90);
    messages.addNow(training("power off", baumer));
    EXPECT_EQ(messages.rowAt(0).at, ring.bus.dateTime(ring.bus.latest().at));
    EXPECT_EQ(messages.rowAt(0).message.at, ring.bus.latest().at);
}

TEST(MessageModel, ForgetsTheBusBeforeWhenThereIsAnother)
{
    test::TrainingBusSession before;
    test::TrainingBusSession now;
    MessageModel messages;
    messages.setBus(before.bus);
    messages.setBus(now.bus);
    before.bus.setOperate(false);
    before.bus.advance(5);
    EXPECT_EQ(messages.rowCount(), 0);
}

TEST(MessageModel, DropsTheOldestWhenItIsFull)
{
    MessageModel messages;
    std::vector<MessageRow> rows(MessageModel::capacity, MessageRow{noon, training("old")});
    rows.front().message = training("oldest");
    messages.setRows(std::move(rows));
    const test::ModelTester tester(messages);
    messages.add(training("newest"), noon);
    EXPECT_LE(messages.rowCount(), MessageModel::capacity);
    EXPECT_GT(messages.rowCount(), MessageModel::capacity * 9 / 10);
    EXPECT_EQ(shown(messages, 0, MessageModel::textColumn), QStringLiteral("old"));
    EXPECT_EQ(shown(messages, messages.rowCount() - 1, MessageModel::textColumn), QStringLiteral("newest"));
}

class MessageFilterTest : public testing::Test
{
protected:
    MessageFilterTest()
    {
        messages.add({.severity = Severity::information, .id = MessageId::busStarted}, noon);
        messages.add(training("Power off", fraba), noon);
        messages.add({.place = baumer, .severity = Severity::fault, .id = MessageId::deviceFaultGone}, noon);
    }
    int count() const { return filter.rowCount(); }

    MessageModel messages;
    MessageFilter filter{messages};
    test::ModelTester tester{filter};
};

TEST_F(MessageFilterTest, ShowsEverythingAtFirst)
{
    EXPECT_EQ(count(), 3);
}

TEST_F(MessageFilterTest, KeepsASeverityAndWorse)
{
    filter.setSeverity(Severity::attention);
    ASSERT_EQ(count(), 1);
    EXPECT_EQ(shown(filter, 0, MessageModel::placeColumn), QStringLiteral("2.0"));
    messages.add({.severity = Severity::attention, .id = MessageId::lateCycles}, noon);
    EXPECT_EQ(count(), 2);
}

TEST_F(MessageFilterTest, KeepsAPlaceOrTheBus)
{
    filter.setPlace({.all = false, .number = fraba});
    ASSERT_EQ(count(), 1);
    EXPECT_EQ(shown(filter, 0, MessageModel::textColumn), QStringLiteral("Power off"));
    filter.setPlace({.all = false});
    ASSERT_EQ(count(), 1);
    EXPECT_EQ(shown(filter, 0, MessageModel::textColumn), QStringLiteral("The bus runs."));
}

TEST_F(MessageFilterTest, FindsTextInAnyColumnInAnyCase)
{
    filter.setText(QStringLiteral(" POWER"));
    EXPECT_EQ(count(), 1);
    filter.setText(QStringLiteral("2.0"));
    EXPECT_EQ(count(), 1);
    filter.setText(QStringLiteral("nowhere"));
    EXPECT_EQ(count(), 0);
}

} // namespace
} // namespace codewheel
