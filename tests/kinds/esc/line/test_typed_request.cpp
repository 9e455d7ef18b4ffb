// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/protocol/esc_scaling.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

QString faultOf(const char *text)
{
    const auto request = typedRequest(QString::fromUtf8(text), esc::defaultFractionBits);
    return request ? QString() : request.error();
}

TEST(TypedRequest, IsTakenInAnyCaseAndWithBlanksAround)
{
    const auto read = typedRequest(QStringLiteral(" 05p "), esc::defaultFractionBits);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, (esc::Request{{5}, esc::Command::position, 0}));
    const auto write = typedRequest(QStringLiteral("03gp5200"), esc::defaultFractionBits);
    ASSERT_TRUE(write);
    EXPECT_EQ(*write, (esc::Request{{3}, esc::Command::writePreset, 0x5200}));
    EXPECT_TRUE(typedRequest(QStringLiteral("00N"), esc::defaultFractionBits));
}

// Each sentence names the part that is wrong.
TEST(TypedRequest, SaysWhatIsWrong)
{
    const struct
    {
        const char *typed;
        const char *named;
    } rows[] = {
        {"", "as in 05P"},
        {"5P", "\"5P\" is not an address"},
        {"20P", "\"20\" is not an address"},
        {"-1P", "\"-1\" is not an address"},
        {"0", "\"0\" is not an address"},
        {"05", "The command is missing behind the address 05"},
        {"05K", "There is no command \"K\""},
        {"05GG", "There is no command \"GG\""},
        {"05\xC3\xA4", "There is no command"},
        {"05P1", "P reads (position) and takes no data: \"1\" is too much"},
        {"05GP", "GP writes (preset) and needs a value"},
        {"05GP000052000", "GP takes 8 hexadecimal digits at most; these are 9"},
        {"05GPxyz", "\"XYZ\" is not a hexadecimal number"},
        {"05GP-1", "\"-1\" is not a hexadecimal number"},
        {"05GP0x12", "\"0X12\" is not a hexadecimal number"},
        {"05GP0", "0h = 0 is outside of what GP takes: 1h = 1 to 1FFFFFFh = 33554431"},
        {"05GM1001", "1001h = 4097 is outside"},
        {"02X20", "20h = 32 is outside of what X takes: 1h = 1 to 1Fh = 31"},
        {"02Y3", "3h = 3 is outside"},
        {"05GF14F8", "14F8h = 5368 is outside of what GF takes: 14F9h = 5369 to 20000000h = 536870912"},
        {"05GF20000001", "20000001h = 536870913 is outside"},
    };
    for (const auto &row : rows)
        EXPECT_TRUE(faultOf(row.typed).contains(QString::fromUtf8(row.named)))
            << row.typed << ": " << faultOf(row.typed).toStdString();
}

TEST(TypedRequest, AScalingFactorIsLimitedByTheFormatOfTheLine)
{
    EXPECT_TRUE(typedRequest(QStringLiteral("05GF14F9"), 29));
    EXPECT_TRUE(typedRequest(QStringLiteral("05GF40000000"), 30));
    EXPECT_FALSE(typedRequest(QStringLiteral("05GF40000000"), 29));
    EXPECT_FALSE(typedRequest(QStringLiteral("05GF14F9"), 30));
}

// A request that is only explained may hold any value; everything else must be right.
TEST(ReadRequest, TakesAnyValueThatItsDigitsHold)
{
    EXPECT_EQ(readRequest(QStringLiteral("02X21")), (esc::Request{{2}, esc::Command::writeAddress, 0x21}));
    EXPECT_EQ(readRequest(QStringLiteral(" 05gp0 ")), (esc::Request{{5}, esc::Command::writePreset, 0}));
    EXPECT_TRUE(readRequest(QStringLiteral("05GFFFFFFFFF")));
    for (const char *wrong : {"", "5P", "05K", "05P1", "05GP", "05GP000052000", "05GPxyz"})
        EXPECT_FALSE(readRequest(QString::fromLatin1(wrong))) << wrong;
}

TEST(TypedRequest, IsKnownAgainByItsBytes)
{
    EXPECT_EQ(sentRequest("\x1B"
                          "05P\r\n"),
              (esc::Request{{5}, esc::Command::position, 0}));
    for (const QByteArray bytes : {"", "\x1B\r\n", "05P\r\n",
                                   "\x1B"
                                   "05p\r\n",
                                   "\x1B"
                                   "05P\n\n"})
        EXPECT_FALSE(sentRequest(bytes)) << bytes.toHex().toStdString();
}

} // namespace
} // namespace codewheel
