// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/device_number.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(DeviceNumber, IsWrittenAndReadAsSegmentDotPosition)
{
    EXPECT_EQ(DeviceNumber::parse(u"6.1"), (DeviceNumber{6, 1}));
    EXPECT_EQ((DeviceNumber{12, 0}).toString(), QStringLiteral("12.0"));
}

TEST(DeviceNumber, IsTheAddressOnASerialLine)
{
    const auto twelve = DeviceNumber::onLine({0x12});
    EXPECT_EQ(twelve.toString(), QStringLiteral("esc:12"));
    EXPECT_EQ(DeviceNumber::parse(u"12"), twelve);
    EXPECT_EQ(DeviceNumber::parse(u"esc:12"), twelve);
    EXPECT_EQ(DeviceNumber::parse(u"1f"), DeviceNumber::onLine({31}));
    EXPECT_TRUE(twelve.isOnLine());
    EXPECT_FALSE((DeviceNumber{1, 2}.isOnLine()));
    EXPECT_NE(twelve, (DeviceNumber{1, 2}));
}

// Manual, "Masteraddress: 00": the place of an encoder that is alone on its line, and not no place.
TEST(DeviceNumber, MayBeTheMasterAddressOfASerialLine)
{
    const auto alone = DeviceNumber::onLine(LineAddress::master());
    EXPECT_TRUE(alone.isOnLine());
    EXPECT_EQ(alone.toString(), QStringLiteral("esc:00"));
    EXPECT_EQ(DeviceNumber::parse(u"00"), alone);
    EXPECT_EQ(DeviceNumber::parse(u"esc:00"), alone);
    EXPECT_NE(alone, DeviceNumber());
    EXPECT_FALSE(DeviceNumber().isOnLine());
}

TEST(DeviceNumber, AnythingElseIsNoDeviceNumber)
{
    for (const QStringView text :
         {u"", u"1", u"1.", u".0", u"0.0", u"+1.0", u"1.0 ", u"1,0", u"-1.0", u"1.0.0", u"1234.0", u"20",
          u"012", u"esc:", u"esc:0", u"esc:1.0", u"1G", u"esc:+1"})
        EXPECT_FALSE(DeviceNumber::parse(text)) << text.toString().toStdString();
}

TEST(LineAddress, IsTwoHexDigitsOnTheWire)
{
    EXPECT_EQ(LineAddress{18}.onWire(), QStringLiteral("12"));
    EXPECT_EQ(LineAddress{5}.onWire(), QStringLiteral("05"));
    EXPECT_EQ(LineAddress{31}.onWire(), QStringLiteral("1F"));
    EXPECT_EQ(LineAddress{18}.shown(), QStringLiteral("12h (18)"));
    EXPECT_EQ(LineAddress::fromWire(u"1F"), LineAddress{31});
    EXPECT_EQ(LineAddress::fromWire(u"0"), LineAddress::master());
    for (const QStringView text : {u"", u"20", u"21", u"0x1", u" 1", u"+1", u"001"})
        EXPECT_FALSE(LineAddress::fromWire(text)) << text.toString().toStdString();
}

} // namespace
} // namespace codewheel
