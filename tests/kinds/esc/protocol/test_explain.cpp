// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_explain.h"
#include "tests/kinds/esc/protocol/conversation.h"

#include <gtest/gtest.h>
#include <set>

namespace codewheel::esc {
namespace {

using Kind = Answer::Kind;

struct ExplainRow
{
    const char *request;
    Answer answer;
    const char *text;
};

Answer value(std::uint32_t number)
{
    return {Kind::value, number, {}};
}

const ExplainRow explainRows[] = {
    {"05P", value(0x1235), "05: position? -> 1235h = 4661"},
    {"05P", value(0), "05: position? -> 0h = 0"},
    {"00O", value(0x7005),
     "00 (any encoder): operating parameters? -> 7005h: limit switch active, resolution per revolution, "
     "calculated factor, scaling on, direction CCW"},
    {"00A", value(0x4000), "00 (any encoder): alarms? -> 4000h: battery flat"},
    {"05A", value(0x5000), "05: alarms? -> 5000h: battery flat, general fault"},
    {"05A", value(0), "05: alarms? -> 0000h: none"},
    {"05E", value(0x9800), "05: warnings? -> 9800h: standstill, lower limit switch on, turning CCW"},
    {"05E", value(0x0098),
     "05: warnings? -> 0098h: bit 7 (not described), battery limit reached, bit 3 (not "
     "described)"},
    {"12V", {Kind::text, 0, "5882 %1 V1.0"}, "12: version? -> 5882 %1 V1.0"},
    {"12N", value(0x12AB34), "12: serial number? -> 0012AB34h"},
    {"12B", value(0x8000), "12: device code? -> 8000h"},
    {"12T", value(123'456), "12: operating time? -> 1E240h = 12345.6 h"},
    {"12F", value(0x1F400000), "12: scaling factor? -> 1F400000h = 0.9765625"},
    {"12D", value(8'192), "12: steps per revolution? -> 2000h = 8192"},
    {"12D", value(0xFFFF), "12: steps per revolution? -> FFFFh = 65535, outside 1 to 8192"},
    {"12D", {Kind::unknownCommand, 0, "03"}, "12: steps per revolution? -> command unknown (03)"},
    // Outside what the tables of the manual state.
    {"12B", value(0x7FFF), "12: device code? -> 7FFFh, outside 8000h to A000h"},
    {"12B", value(0xA000), "12: device code? -> A000h"},
    {"12B", value(0xA001), "12: device code? -> A001h, outside 8000h to A000h"},
    {"12F", value(1), "12: scaling factor? -> 00000001h = 1.862645149e-09, outside 0.00001 to 1.0"},
    {"12F", value(0x20000000), "12: scaling factor? -> 20000000h = 1"},
    {"12F", value(0x20000001), "12: scaling factor? -> 20000001h = 1.000000002, outside 0.00001 to 1.0"},
    {"12F", value(0x7FFFFFFF), "12: scaling factor? -> 7FFFFFFFh = 3.999999998, outside 0.00001 to 1.0"},
    {"12F", value(0x80000000), "12: scaling factor? -> 80000000h = -4, outside 0.00001 to 1.0"},
    {"12H", value(0x02000000), "12: upper limit switch? -> 2000000h = 33554432"},
    {"12L", value(0x02000000), "12: lower limit switch? -> 2000000h = 33554432"},
    {"12H", value(0x02000001), "12: upper limit switch? -> 2000001h = 33554433, outside 1 to 33554432"},
    {"09GF1", accepted,
     "09: set scaling factor to 00000001h = 1.862645149e-09, outside 0.00001 to 1.0 -> accepted"},
    {"03GP5200", accepted, "03: set preset to 5200h = 20992 -> accepted"},
    {"03GP0",
     {Kind::outOfRange, 0, "05"},
     "03: set preset to 0h = 0, outside 1 to 33554431 -> incomplete or out of range (05)"},
    {"03GR360", accepted, "03: set steps per revolution to 360h = 864 -> accepted"},
    {"12GM120", accepted, "12: set number of revolutions to 120h = 288 -> accepted"},
    {"09GF1F400000", accepted, "09: set scaling factor to 1F400000h = 0.9765625 -> accepted"},
    {"02GD1", accepted, "02: set direction to 1 (CCW) -> accepted"},
    {"02GD0", accepted, "02: set direction to 0 (CW) -> accepted"},
    {"02GS0", accepted, "02: set scaling to 0 (off) -> accepted"},
    {"02GS2", accepted, "02: set scaling to 2h = 2, outside 0 to 1 -> accepted"},
    {"02X21", accepted, "02: set device address to 21h = 33, outside 1 to 31 -> accepted"},
    {"02Y1", accepted, "02: set baud rate to 1 (9600 Bd) -> accepted"},
};

TEST(EscExplain, RequestsAndAnswersInWords)
{
    for (const ExplainRow &row : explainRows)
        EXPECT_EQ(exchangeText(*parseRequest(row.request), row.answer), QString::fromLatin1(row.text));
}

TEST(EscExplain, EachSideAlone)
{
    const Request request = *parseRequest("05P");
    EXPECT_EQ(requestText(request), QStringLiteral("05: position?"));
    EXPECT_EQ(answerText(request, value(0x1235)), QStringLiteral("1235h = 4661"));
}

TEST(EscExplain, TheBytesOfWarningsMayBeSwapped)
{
    EXPECT_EQ(answerText(*parseRequest("00E"), value(0x0098), {.swapWarningBytes = true}),
              QStringLiteral("0098h, bytes swapped 9800h: standstill, lower limit switch on, turning CCW"));
    EXPECT_EQ(answerText(*parseRequest("00A"), value(0x4000), {.swapWarningBytes = true}),
              QStringLiteral("4000h: battery flat"));
}

TEST(EscExplain, TheFractionOfTheScalingFactorIsSettable)
{
    EXPECT_EQ(answerText(*parseRequest("09F"), value(0x1F400000), {.fractionBits = 30}),
              QStringLiteral("1F400000h = 0.48828125"));
    EXPECT_EQ(answerText(*parseRequest("09F"), value(0x40000000), {.fractionBits = 30}),
              QStringLiteral("40000000h = 1"));
    EXPECT_EQ(answerText(*parseRequest("09F"), value(0x40000001), {.fractionBits = 30}),
              QStringLiteral("40000001h = 1.000000001, outside 0.00001 to 1.0"));
}

TEST(EscExplain, EveryCommandHasAName)
{
    std::set<QString> names;
    for (const CommandShape &shape : allCommands()) {
        EXPECT_FALSE(commandName(shape.command).isEmpty());
        if (!shape.writes) {
            EXPECT_TRUE(names.insert(commandName(shape.command)).second);
        }
    }
}

} // namespace
} // namespace codewheel::esc
