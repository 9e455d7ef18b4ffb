// SPDX-License-Identifier: GPL-3.0-or-later
// Requests and answers are literal: the manual's bytes, or worked out by hand.
#include "kinds/esc/simulator/simulated_esc_encoder.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Interface = EscEncoderPlan::Interface;
using AddressDigits = EscEncoderPlan::AddressDigits;

constexpr std::int64_t hour = 3'600'000; // ms

class EscEncoder : public testing::Test
{
protected:
    void make(const EscEncoderPlan &plan) { m_encoder.emplace(plan); }
    SimulatedEscEncoder &encoder() { return *m_encoder; }

    // The answer to these bytes; "-" for none.
    std::string hear(const std::string &bytes)
    {
        std::string heard = "-";
        for (const char byte : bytes)
            if (const auto reply = m_encoder->hear(byte)) {
                m_baudRate = reply->baudRate;
                heard = reply->bytes.toStdString();
            }
        return heard;
    }
    // The same with only the text between ESC and CR LF, and without the answer's line ends.
    std::string ask(const std::string &text)
    {
        std::string answer = hear("\x1B" + text + "\r\n");
        while (answer.ends_with('\n') || answer.ends_with('\r'))
            answer.pop_back();
        return answer.starts_with("\r\n") ? answer.substr(2) : answer;
    }
    void pass(std::int64_t milliseconds)
    {
        for (; milliseconds > 0; --milliseconds)
            m_encoder->cycle();
    }

    std::optional<SimulatedEscEncoder> m_encoder{EscEncoderPlan{.address = {5}, .raw = 0x1235}};
    int m_baudRate = 0;
};

// Manual, "Read actual Position".
TEST_F(EscEncoder, AnswersThePositionAsTheManualPrintsIt)
{
    EXPECT_EQ(hear("\x1B\x30\x35\x50\x0D\x0A"), "\x0D\x0A\x30\x30\x30\x30\x31\x32\x33\x35\x0D\x0A");
}

TEST_F(EscEncoder, AnswersAsDelivered)
{
    make({.address = {5}, .raw = 0x1235, .serialNumber = 0x12D591, .operatingTime = 0x324C});
    const std::pair<const char *, const char *> rows[] = {
        {"O", "2000"},     {"V", "5882 RS485 V1.2 SIMULATED"},
        {"M", "02000000"}, {"D", "2000"},
        {"S", "00000001"}, {"A", "0000"},
        {"E", "8000"},     {"T", "0000324C"},
        {"C", "00000000"}, {"N", "0012D591"},
        {"H", "01FFFFFF"}, {"L", "00000001"},
        {"F", "20000000"}, {"B", "8000"},
        {"U", "1000"},     {"P", "00001235"},
    };
    for (const auto &[command, answer] : rows)
        EXPECT_EQ(ask(std::string("05") + command), answer) << command;
    EXPECT_EQ(ask("05V").size(), 25U);
}

TEST_F(EscEncoder, AnswersOnItsAddressAndOnTheMasterAddress)
{
    EXPECT_EQ(ask("05P"), "00001235");
    EXPECT_EQ(ask("00P"), "00001235");
    EXPECT_EQ(ask("04P"), "-");
    EXPECT_EQ(ask("50P"), "-");
    EXPECT_EQ(ask("5P"), "-");
    EXPECT_EQ(ask("P"), "-");
    EXPECT_EQ(ask(""), "-");
}

TEST_F(EscEncoder, AnswersAcceptedUnknownAndOutOfRangeAsTheManualDoes)
{
    EXPECT_EQ(hear("\x1B"
                   "05GP00005200\r\n"),
              "\r\n");
    for (const char *unknown : {"05Q", "05GQ1", "05Z00000001", "05p", "051"})
        EXPECT_EQ(hear("\x1B" + std::string(unknown) + "\r\n"), "03\r\n") << unknown;
    for (const char *refused :
         {"05",           "05G",          "05GP",         "05GP5200",     "05GP000052000", "05GP0000520G",
          "05P1",         "05V1",         "05GP00000000", "05GP02000000", "05GR00000000",  "05GR00002001",
          "05GM0000",     "05GM1001",     "05GT00000000", "05GT02000000", "05GL00000000",  "05GH02000000",
          "05GF20000001", "05GF00000000", "05GF000014F7", "05GFFFFFFFFF", "05GD2",         "05GS2",
          "05GD",         "05X00",        "05X20",        "05X1",         "05Y3",          "05Y"})
        EXPECT_EQ(hear("\x1B" + std::string(refused) + "\r\n"), "05\r\n") << refused;
    EXPECT_EQ(ask("05P"), "00005200"); // the refused ones changed nothing
    EXPECT_EQ(ask("05O"), "2000");
}

TEST_F(EscEncoder, KeepsWhatIsWritten)
{
    const struct
    {
        const char *write;
        const char *read;
        const char *answer;
    } rows[] = {
        {"05GL00000100", "05L", "00000100"}, {"05GH00100000", "05H", "00100000"},
        {"05GM0120", "05U", "0120"},         {"05GR00000360", "05D", "0360"},
        {"05GT00100000", "05M", "00100000"}, {"05GF1F400000", "05F", "1F400000"},
        {"05GP00005200", "05S", "00005200"}, {"05gl00000001", "05L", "00000100"},
    };
    for (const auto &row : rows) {
        ask(row.write);
        EXPECT_EQ(ask(row.read), row.answer) << row.write;
    }
}

TEST_F(EscEncoder, ItsLimitsAreTheTables)
{
    for (const char *accepted :
         {"05GP00000001", "05GP01FFFFFF", "05GR00000001", "05GR00002000", "05GM0001", "05GM1000",
          "05GT00000001", "05GT01FFFFFF", "05GL01FFFFFF", "05GH00000001", "05GF20000000", "05GF000014F8",
          "05GD1", "05GD0", "05GS1", "05GS0", "05gf20000000"})
        EXPECT_EQ(ask(accepted), accepted[2] == 'g' ? "03" : "") << accepted;
}

TEST_F(EscEncoder, ThePresetMovesThePositionAndTellsTheOffset)
{
    EXPECT_EQ(ask("05GP00005200"), "");
    EXPECT_EQ(ask("05P"), "00005200");
    EXPECT_EQ(ask("05C"), "00003FCB"); // 5200h - 1235h
    encoder().shaft().turnBy(0x10);
    EXPECT_EQ(ask("05P"), "00005210");
    EXPECT_EQ(ask("05GP00000001"), "");
    EXPECT_EQ(ask("05C"), "01FFEDBC"); // 1 - 1245h, on the range of 2000000h
    EXPECT_EQ(ask("05P"), "00000001");
}

TEST_F(EscEncoder, CountsDownCounterClockwiseAndWithVrHigh)
{
    ask("05GD1");
    EXPECT_EQ(ask("05O"), "2001");
    EXPECT_EQ(ask("05P"), "01FFEDCA"); // 1FFFFFFh - 1235h
    encoder().shaft().turnBy(2);
    EXPECT_EQ(ask("05P"), "01FFEDC8");
    ask("05GD0");
    EXPECT_EQ(ask("05P"), "00001237");
    encoder().condition().vrHigh = true;
    EXPECT_EQ(ask("05P"), "01FFEDC8");
    EXPECT_EQ(ask("05O"), "2000"); // the set value, not the wired one
}

// 864 steps per turn: 360h x 2^29 / 8192 = 3600000h.
TEST_F(EscEncoder, AResolutionCountsOnceItsFactorWasSent)
{
    make({.address = {5}, .raw = 8192});
    ask("05GS1");
    ask("05GR00000360");
    EXPECT_EQ(ask("05D"), "0360");
    EXPECT_EQ(ask("05M"), "00360000"); // x 4096
    EXPECT_EQ(ask("05O"), "2004");
    EXPECT_EQ(ask("05P"), "00002000"); // not yet
    ask("05GF03600000");
    EXPECT_EQ(ask("05O"), "3004");
    EXPECT_EQ(ask("05P"), "00000360");
    encoder().shaft().turnTo(33'554'431);
    EXPECT_EQ(ask("05P"), "0035FFFF");
    EXPECT_EQ(ask("05GP00360000"), "05"); // beyond the range
    ask("05GM0002");
    EXPECT_EQ(ask("05M"), "000006C0");
    EXPECT_EQ(ask("05P"), "000006BF");
    ask("05GS0");
    EXPECT_EQ(ask("05P"), "01FFFFFF");
}

// 100000h over 4096 turns: 256 steps per turn, 100000h x 2^29 / 2^25 = 1000000h.
TEST_F(EscEncoder, ATotalRangeCountsOnceItsFactorWasSent)
{
    make({.address = {5}, .raw = 33'554'431});
    ask("05GS1");
    ask("05GT00100000");
    EXPECT_EQ(ask("05O"), "0004"); // total measuring range
    EXPECT_EQ(ask("05P"), "01FFFFFF");
    ask("05GF01000000");
    EXPECT_EQ(ask("05O"), "1004");
    EXPECT_EQ(ask("05P"), "000FFFFF");
}

TEST_F(EscEncoder, TheFactorMayHaveOtherFractionBits)
{
    make({.address = {5}, .raw = 8192, .fractionBits = 28});
    EXPECT_EQ(ask("05F"), "10000000");
    EXPECT_EQ(ask("05GF10000001"), "05");
    ask("05GS1");
    ask("05GR00001000");
    ask("05GF08000000");
    EXPECT_EQ(ask("05P"), "00001000");
}

TEST_F(EscEncoder, LimitSwitchesAreActiveOnceALimitIsSet)
{
    EXPECT_EQ(ask("05O"), "2000");
    ask("05GL00002000");
    EXPECT_EQ(ask("05O"), "6000");
    EXPECT_EQ(ask("05E"), "D000"); // stands, position warning, lower limit
    encoder().shaft().turnTo(0x2000);
    EXPECT_EQ(ask("05E"), "8000");
    ask("05GH00002FFF");
    encoder().shaft().turnTo(0x3000);
    EXPECT_EQ(ask("05E"), "E000"); // stands, position warning, upper limit
    encoder().shaft().turnTo(0x2FFF);
    EXPECT_EQ(ask("05E"), "8000");
    ask("05GL00000001");
    ask("05GH01FFFFFF");
    EXPECT_EQ(ask("05O"), "2000");
}

// Manual, "Read Operating Parameters": 7005.
TEST_F(EscEncoder, TheManualsOperatingParametersCanBeReached)
{
    for (const char *write : {"05GD1", "05GR00001000", "05GF10000000", "05GS1", "05GH00100000"})
        EXPECT_EQ(ask(write), "") << write;
    EXPECT_EQ(ask("00O"), "7005");
}

TEST_F(EscEncoder, TellsHowItsShaftMoves)
{
    encoder().shaft().setSpeed(10);
    EXPECT_EQ(ask("05E"), "0000");
    encoder().shaft().setSpeed(-10);
    EXPECT_EQ(ask("05E"), "0800");
    encoder().shaft().setSpeed(6'100);
    EXPECT_EQ(ask("05E"), "0001");
    EXPECT_EQ(ask("05A"), "1000");
    encoder().shaft().setSpeed(0);
    ask("05GP00000500");
    EXPECT_EQ(ask("05E"), "8020"); // at the reference
    encoder().shaft().setSpeed(60);
    pass(1'000);
    EXPECT_EQ(ask("05P"), "00002500"); // a turn of 2000h
}

// Manual, "Alarm Parameters": 4000 battery flat, 5000 battery flat and a general fault.
TEST_F(EscEncoder, TellsAlarmsAndWarningsBitByBit)
{
    EscCondition &condition = encoder().condition();
    condition.batteryFlat = true;
    EXPECT_EQ(ask("05A"), "4000");
    condition.batteryLimit = true;
    EXPECT_EQ(ask("05A"), "5000");
    EXPECT_EQ(ask("05E"), "8010");
    condition = {.temperatureExceeded = true};
    EXPECT_EQ(ask("05A"), "9000");
    EXPECT_EQ(ask("05E"), "8000");
    condition = {.lightControl = true};
    EXPECT_EQ(ask("05A"), "1000");
    EXPECT_EQ(ask("05E"), "8002");
    condition = {.positionError = true};
    EXPECT_EQ(ask("05A"), "0001");
}

// Manual, "Read Warning Parameters": 0098 for bits 15, 12 and 11.
TEST_F(EscEncoder, MaySwapTheBytesOfItsWarnings)
{
    make({.address = {5}, .swapsWarningBytes = true});
    EXPECT_EQ(ask("05E"), "0080");
}

TEST_F(EscEncoder, CountsItsOperatingTimeInTenthsOfAnHour)
{
    make({.address = {5}, .operatingTime = 0xFF});
    pass(hour / 10 - 1);
    EXPECT_EQ(ask("05T"), "000000FF");
    pass(1);
    EXPECT_EQ(ask("05T"), "00000100");
    encoder().condition().powered = false;
    pass(hour);
    encoder().condition().powered = true;
    EXPECT_EQ(ask("05T"), "00000100");
}

TEST_F(EscEncoder, AnotherAddressIsTakenAsHexadecimalOrAsDecimal)
{
    EXPECT_EQ(ask("05X12"), "");
    EXPECT_EQ(ask("05P"), "-");
    EXPECT_EQ(ask("12P"), "00001235");
    EXPECT_EQ(ask("12X21"), "05");
    make({.address = {2}, .addressDigits = AddressDigits::decimal});
    EXPECT_EQ(ask("02X1F"), "05");
    EXPECT_EQ(ask("02X32"), "05");
    EXPECT_EQ(ask("02X21"), ""); // manual: "address will be set to 21"
    EXPECT_EQ(ask("15P"), "00000000");
}

TEST_F(EscEncoder, AnswersAtTheOldBaudRateAndGoesOnAtTheNewOne)
{
    EXPECT_EQ(ask("05Y1"), "");
    EXPECT_EQ(m_baudRate, 19'200);
    EXPECT_EQ(encoder().baudRate(), 9'600);
    EXPECT_EQ(ask("05Y2"), "");
    EXPECT_EQ(m_baudRate, 9'600);
    EXPECT_EQ(encoder().baudRate(), 4'800);
    EXPECT_EQ(ask("05Y0"), "");
    EXPECT_EQ(encoder().baudRate(), 19'200);
}

TEST_F(EscEncoder, FindsItsRequestAmongNoise)
{
    EXPECT_EQ(hear("noise\r\n\x80\xFF"), "-");
    EXPECT_EQ(hear("\x1B"
                   "05\x1B"
                   "05P\r\n"),
              "\r\n00001235\r\n");
    EXPECT_EQ(hear("\x1B"
                   "05P\r"),
              "-");
    EXPECT_EQ(hear("\n"), "\r\n00001235\r\n");
    EXPECT_EQ(hear("\x1B"
                   "05P\n"),
              "-"); // without CR
    EXPECT_EQ(hear("\x1B" + std::string(40, '5') + "\r\n"), "-");
}

TEST_F(EscEncoder, JunkEndsARequest)
{
    hear("\x1B"
         "05");
    encoder().hearJunk();
    EXPECT_EQ(hear("P\r\n"), "-");
}

TEST_F(EscEncoder, WithStOpenNoCommandWorks)
{
    make({.address = {5}, .interface = Interface::rs422});
    EXPECT_EQ(ask("05V"), "5882 RS422 V1.2 SIMULATED");
    encoder().condition().stOpen = true;
    EXPECT_EQ(ask("05GP00005200"), "-");
    encoder().condition().stOpen = false;
    EXPECT_EQ(ask("05P"), "00000000");
    make({.address = {5}}); // RS-485 has no such input
    encoder().condition().stOpen = true;
    EXPECT_EQ(ask("05P"), "00000000");
}

TEST_F(EscEncoder, AMuteOneActsAndOneWithoutPowerDoesNot)
{
    encoder().condition().mute = true;
    EXPECT_EQ(ask("05GP00005200"), "-");
    encoder().condition().mute = false;
    EXPECT_EQ(ask("05P"), "00005200");
    encoder().condition().powered = false;
    EXPECT_EQ(ask("05GP00000001"), "-");
    encoder().condition().powered = true;
    EXPECT_EQ(ask("05P"), "00005200"); // kept
}

} // namespace
} // namespace codewheel
