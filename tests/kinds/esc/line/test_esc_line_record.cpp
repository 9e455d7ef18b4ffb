// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_record.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Kind = esc::EscLineRow::Kind;

EscLineRecord example()
{
    return {.begin = QDateTime(QDate(2026, 11, 21), QTime(12, 0, 0, 5), Qt::OffsetFromUTC, 3600),
            .port = QStringLiteral("/dev/ttyUSB0"),
            .baudRate = 9'600,
            .rows = {{{1ms, Kind::sent,
                       "\x1B"
                       "05P\r\n"},
                      true},
                     {{12345us, Kind::answer, "\r\n00001235\r\n"}, true},
                     {{20ms, Kind::echo, "\x1B"}},
                     {{30ms, Kind::garbage, QByteArray("\x00\xFF", 2)}},
                     {{40ms, Kind::late, "\r\n"}}}};
}

QByteArray file(const QByteArray &rows, const QByteArray &head = "\"version\": 1,")
{
    return "{\n\"format\": \"codewheel-line-session\",\n" + head +
           "\n\"begin\": \"2026-11-21T12:00:00.000+01:00\",\n\"port\": \"\",\n\"baudRate\": 19200,\n"
           "\"rows\": [\n" +
           rows + "\n]\n}\n";
}

QString fault(const QByteArray &json)
{
    const auto read = lineRecordFromJson(json, QStringLiteral("a.json"));
    return read ? QString() : read.error();
}

TEST(EscLineRecord, ComesBackAsItWasKept)
{
    const QByteArray json = lineRecordToJson(example());
    const auto read = lineRecordFromJson(json, QStringLiteral("a.json"));
    ASSERT_TRUE(read) << read.error().toStdString();
    EXPECT_EQ(*read, example());
    EXPECT_EQ(lineRecordToJson(*read), json);
}

TEST(EscLineRecord, IsARowALine)
{
    const QByteArray json = lineRecordToJson(example());
    EXPECT_TRUE(json.contains(
        "{\"at\": 1000, \"kind\": \"sent\", \"bytes\": \"1B 30 35 50 0D 0A\", \"typed\": true}"))
        << json.toStdString();
    EXPECT_TRUE(json.contains("\"begin\": \"2026-11-21T12:00:00.005+01:00\"")) << json.toStdString();
}

TEST(EscLineRecord, RefusesWhatBreaksARuleWithItsLine)
{
    const QByteArray good = R"({"at": 1, "kind": "sent", "bytes": "1B"})";
    EXPECT_EQ(fault(file(good)), QString());
    const struct
    {
        QByteArray json;
        const char *named;
    } rows[] = {
        {"{}", "a.json, line 1: This is not a session of a serial line"},
        {"[]", "This is not a session of a serial line"},
        {"", "a.json, line 1"},
        {file(good, "\"version\": 2,"), "a.json, line 3, version: Only version 1"},
        {file(R"({"at": -1, "kind": "sent", "bytes": "1B"})"), "line 8, rows[0].at"},
        {file(R"({"at": 1, "kind": "written", "bytes": "1B"})"), "line 8, rows[0].kind"},
        {file(R"({"at": 1, "kind": "sent", "bytes": "1B3"})"), "line 8, rows[0].bytes: Bytes are expected"},
        {file(R"({"at": 1, "kind": "sent", "bytes": "1B,30"})"), "rows[0].bytes"},
        {file(R"({"at": 1, "kind": "sent", "bytes": ""})"), "rows[0].bytes"},
        {file(R"({"at": 1, "kind": "sent", "bytes": "1B", "to": 1})"), "rows[0]"},
        {file(good + ",\n" + R"({"at": 1, "kind": "sent"})"), "line 9, rows[1].bytes"},
        {file(good) + "x", "line"},
        {lineRecordToJson(example()).replace("2026-11-21", "2026-13-21"), "begin: A date and time"},
    };
    for (const auto &row : rows)
        EXPECT_TRUE(fault(row.json).contains(QLatin1String(row.named)))
            << row.named << "\nsaid: " << fault(row.json).toStdString();
}

} // namespace
} // namespace codewheel
