// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_csv.h"

namespace codewheel {
namespace {

const QDateTime afternoon(QDate(2026, 3, 1), QTime(14, 2, 0, 10), Qt::OffsetFromUTC, 3600);

TEST(MessageCsv, HasIsoTimeAndNeutralKeys)
{
    const std::vector<MessageRow> rows{
        {afternoon, {.severity = Severity::information, .id = MessageId::busStarted}},
        {afternoon,
         {.place = DeviceNumber{1, 0},
          .severity = Severity::fault,
          .id = MessageId::deviceFault,
          .arguments = {std::int64_t{3}, Word{0x86000000}}}}};
    EXPECT_EQ(messagesAsCsv(rows).toStdString(),
              "time,severity,place,code,text\r\n"
              "2026-03-01T14:02:00.010+01:00,information,,busStarted,\"The bus runs.\"\r\n"
              "2026-03-01T14:02:00.010+01:00,fault,1.0,deviceFault,"
              "\"The encoder reports error 3 (IN 86000000).\"\r\n");
}

TEST(MessageCsv, DoublesQuotesAndKeepsUtf8)
{
    const std::vector<MessageRow> rows{
        {afternoon, {.id = MessageId::training, .arguments = {QStringLiteral("say \"¼, turn\"")}}}};
    EXPECT_TRUE(messagesAsCsv(rows).endsWith("training,\"say \"\"\xC2\xBC, turn\"\"\"\r\n"))
        << messagesAsCsv(rows).constData();
}

TEST(MessageCsv, NamesWhatWasRefused)
{
    Message refused{.severity = Severity::attention};
    refused.refusal = Refusal{RefusalKind::stopped, RefusalId::alarmStop, {}};
    EXPECT_TRUE(messagesAsCsv({{afternoon, refused}}).contains(",attention,,alarmStop,\""));
}

} // namespace
} // namespace codewheel
