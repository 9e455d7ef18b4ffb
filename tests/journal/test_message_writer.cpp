// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_writer.h"
#include "tests/support/places.h"

#include <QBuffer>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Format = MessageWriter::Format;

const QDateTime twoOClock(QDate(2026, 3, 1), QTime(14, 2, 0, 10));

QString written(Format format, const std::vector<Message> &messages)
{
    std::vector<StoredMessage> stored;
    stored.reserve(messages.size());
    for (const Message &message : messages)
        stored.push_back(storedMessage(message, twoOClock));
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    MessageWriter writer(buffer, format);
    EXPECT_TRUE(writer.begin() && writer.write(stored) && writer.end());
    return QString::fromUtf8(buffer.data());
}

Message trainingText(const char *what)
{
    return {.id = MessageId::training, .arguments = {QString::fromUtf8(what)}};
}

TEST(MessageWriter, WritesCsv)
{
    const QString time = twoOClock.toOffsetFromUtc(twoOClock.offsetFromUtc()).toString(Qt::ISODateWithMs);
    EXPECT_EQ(written(Format::csv, {{.id = MessageId::busStarted},
                                    {.place = "1.0"_ring,
                                     .severity = Severity::fault,
                                     .id = MessageId::deviceFault,
                                     .arguments = {std::int64_t{3}, Word{0x86000000}}}}),
              QStringLiteral("time,severity,place,code,text,bus\r\n"
                             "%1,information,,busStarted,\"The bus runs.\",\r\n"
                             "%1,fault,1.0,deviceFault,\"The encoder reports error 3 (IN 86000000).\",1\r\n")
                  .arg(time));
    EXPECT_NE(twoOClock.toOffsetFromUtc(7200).toString(Qt::ISODateWithMs), twoOClock.toString(Qt::ISODate));
}

TEST(MessageWriter, ACodeFromElsewhereIsNoFormula)
{
    StoredMessage stored = storedMessage({.id = MessageId::busStarted}, twoOClock);
    stored.code = QStringLiteral("=1+2,3");
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    MessageWriter writer(buffer, Format::csv);
    ASSERT_TRUE(writer.begin() && writer.write({stored}) && writer.end());
    EXPECT_TRUE(buffer.data().contains(",\"'=1+2,3\",")) << buffer.data().toStdString();
}

TEST(MessageWriter, TheBusStandsByItself)
{
    const QString csv = written(Format::csv, {{.place = Place{{4}, NodeId("esc:05")}}});
    EXPECT_TRUE(csv.contains(QStringLiteral(",esc:05,"))) << csv.toStdString();
    EXPECT_TRUE(csv.endsWith(QStringLiteral(",4\r\n"))) << csv.toStdString();
}

TEST(MessageWriter, DoublesQuotesAndKeepsUtf8)
{
    EXPECT_TRUE(written(Format::csv, {trainingText("say \"¼, turn\"")})
                    .endsWith(QStringLiteral("training,\"say \"\"¼, turn\"\"\",\r\n")));
}

TEST(MessageWriter, NamesWhatWasRefused)
{
    Message refused{.severity = Severity::attention};
    refused.refusal = Refusal{RefusalKind::stopped, RefusalId::alarmStop, {}};
    EXPECT_TRUE(written(Format::csv, {refused}).contains(QStringLiteral(",attention,,alarmStop,\"")));
}

TEST(MessageWriter, WritesAPage)
{
    const QString html = written(Format::html, {trainingText("<script>1 & 2</script>")});
    EXPECT_TRUE(html.startsWith(QStringLiteral("<!DOCTYPE html>")));
    EXPECT_TRUE(html.contains(QStringLiteral("<td></td><td>&lt;script&gt;1 &amp; 2&lt;/script&gt;</td>")));
    EXPECT_TRUE(html.contains(QStringLiteral("14:02:00.010</td>")));
    EXPECT_TRUE(html.contains(QStringLiteral("<tr class=\"information\">")));
    EXPECT_TRUE(html.endsWith(QStringLiteral("</html>\n")));
}

TEST(MessageWriter, GoesByTheNameOfTheFile)
{
    EXPECT_EQ(MessageWriter::formatOf(QStringLiteral("a.CSV")), Format::csv);
    EXPECT_EQ(MessageWriter::formatOf(QStringLiteral("a.html")), Format::html);
    EXPECT_EQ(MessageWriter::formatOf(QStringLiteral("a.pdf")), std::nullopt);
}

} // namespace
} // namespace codewheel
