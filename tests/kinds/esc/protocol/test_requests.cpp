// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_request.h"

#include <gtest/gtest.h>

namespace codewheel::esc {
namespace {

struct RequestRow
{
    std::uint8_t address;
    Command command;
    std::uint32_t data;
    const char *text;
    const char *bytes; // hexadecimal
};

// The examples of the manual, except where they contradict its tables (GD is printed as GF, O as 0).
const RequestRow requestRows[] = {
    {0x05, Command::position, 0, "05P", "1B303550 0D0A"},
    {0x00, Command::operatingParameters, 0, "00O", "1B30304F 0D0A"},
    {0x00, Command::alarms, 0, "00A", "1B303041 0D0A"},
    {0x00, Command::warnings, 0, "00E", "1B303045 0D0A"},
    {0x03, Command::writePreset, 0x5200, "03GP00005200", "1B3033 4750 3030303035323030 0D0A"},
    {0x03, Command::writeStepsPerTurn, 864, "03GR00000360", "1B3033 4752 3030303030333630 0D0A"},
    {0x12, Command::writeRevolutions, 0x120, "12GM0120", "1B3132 474D 30313230 0D0A"},
    {0x09, Command::writeMeasuringRange, 0x100000, "09GT00100000", "1B3039 4754 3030313030303030 0D0A"},
    {0x09, Command::writeLowerLimit, 0x100, "09GL00000100", "1B3039 474C 3030303030313030 0D0A"},
    {0x09, Command::writeUpperLimit, 0x100000, "09GH00100000", "1B3039 4748 3030313030303030 0D0A"},
    {0x09, Command::writeScalingFactor, 0x1F400000, "09GF1F400000", "1B3039 4746 3146343030303030 0D0A"},
    {0x02, Command::writeDirection, 1, "02GD1", "1B3032 4744 31 0D0A"},
    {0x02, Command::writeScaling, 0, "02GS0", "1B3032 4753 30 0D0A"},
    {0x02, Command::writeAddress, 0x21, "02X21", "1B3032 58 3231 0D0A"},
    {0x02, Command::writeBaudRate, 1, "02Y1", "1B3032 59 31 0D0A"},
    {0x1F, Command::version, 0, "1FV", "1B314656 0D0A"},
    {0x0A, Command::writePreset, 0x1FFFFFF, "0AGP01FFFFFF", "1B3041 4750 3031464646464646 0D0A"},
};

Request requestOf(const RequestRow &row)
{
    return {EscLineAddress{row.address}, row.command, row.data};
}

TEST(EscRequests, TextAndBytesAreThoseOfTheManual)
{
    for (const RequestRow &row : requestRows) {
        SCOPED_TRACE(row.text);
        EXPECT_EQ(requestOf(row).text(), row.text);
        EXPECT_EQ(requestOf(row).bytes(), QByteArray::fromHex(row.bytes));
    }
}

TEST(EscRequests, WhatWasTypedIsThatRequest)
{
    for (const RequestRow &row : requestRows) {
        SCOPED_TRACE(row.text);
        EXPECT_EQ(parseRequest(row.text), requestOf(row));
        EXPECT_EQ(parseRequest(QByteArray(row.text).toLower()), requestOf(row));
    }
}

TEST(EscRequests, ShortDataArePadded)
{
    EXPECT_EQ(parseRequest("03GP5200"), (Request{EscLineAddress{3}, Command::writePreset, 0x5200}));
    EXPECT_EQ(parseRequest("03gp5200")->text(), "03GP00005200");
    EXPECT_EQ(parseRequest("12GM1")->text(), "12GM0001");
    EXPECT_EQ(parseRequest("02x5")->text(), "02X05");
    EXPECT_EQ(parseRequest("09gf1f400000")->text(), "09GF1F400000");
}

TEST(EscRequests, NothingElseIsOne)
{
    const char *const texts[] = {
        "",         "0",         "05",        "5P",        "P",
        "005P",     "20P",       "FFP",       "0xP",       "0GP5",
        "05Q",      "05G",       "05GP",      "05G5200",   "05P1",
        "05V ",     " 05P",      "05 P",      "05P\r\n",   "\03305P",
        "03GP",     "02GD",      "02GD10",    "12GM00120", "03GP000052001",
        "03GP52G0", "03GP-200",  "03GP0x52",  "03GP 5200", "02X021",
        "02Y00",    "03GP5200h", "\xFF\xFFP", "05\xD0",    "05PP",
        "1GP5200",  "+5P",       "-1P",
    };
    for (const char *text : texts)
        EXPECT_EQ(parseRequest(text), std::nullopt) << text;
    EXPECT_EQ(parseRequest(QByteArrayView("05P\0", 4)), std::nullopt);
}

TEST(EscRequests, EveryRequestIsReadAsWhatItIs)
{
    for (const CommandShape &shape : allCommands()) {
        for (std::uint8_t address = 0; address <= EscLineAddress::last; ++address) {
            for (const std::uint32_t data : {shape.minimum, shape.maximum}) {
                const Request request{EscLineAddress{address}, shape.command, shape.writes ? data : 0};
                EXPECT_EQ(parseRequest(request.text()), request) << request.text().constData();
            }
        }
    }
}

} // namespace
} // namespace codewheel::esc
