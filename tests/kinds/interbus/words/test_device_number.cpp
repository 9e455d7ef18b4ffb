// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/interbus/words/device_number.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(DeviceNumber, IsWrittenAndReadAsSegmentDotPosition)
{
    EXPECT_EQ(DeviceNumber::parse(u"6.1"), (DeviceNumber{6, 1}));
    EXPECT_EQ((DeviceNumber{12, 0}).toString(), QStringLiteral("12.0"));
}

TEST(DeviceNumber, IsAPlaceAndBack)
{
    EXPECT_EQ((DeviceNumber{12, 63}).node(), NodeId("12.63"));
    EXPECT_EQ(DeviceNumber::of(NodeId("12.63")), (DeviceNumber{12, 63}));
    EXPECT_TRUE(DeviceNumber().node().isEmpty());
    for (const char *other : {"", "esc:12", "12"})
        EXPECT_EQ(DeviceNumber::of(NodeId(other)), DeviceNumber()) << other;
}

TEST(DeviceNumber, AnythingElseIsNoDeviceNumber)
{
    for (const QStringView text :
         {u"", u"1", u"1.", u".0", u"0.0", u"+1.0", u"1.0 ", u"1,0", u"-1.0", u"1.0.0", u"1234.0", u"20",
          u"012", u"esc:", u"esc:0", u"esc:1.0", u"1G", u"esc:+1"})
        EXPECT_FALSE(DeviceNumber::parse(text)) << text.toString().toStdString();
}

TEST(EscLineAddress, IsTwoHexDigitsOnTheWire)
{
    EXPECT_EQ(EscLineAddress{18}.onWire(), QStringLiteral("12"));
    EXPECT_EQ(EscLineAddress{5}.onWire(), QStringLiteral("05"));
    EXPECT_EQ(EscLineAddress{31}.onWire(), QStringLiteral("1F"));
    EXPECT_EQ(EscLineAddress{18}.shown(), QStringLiteral("12h (18)"));
    EXPECT_EQ(EscLineAddress::fromWire(u"1F"), EscLineAddress{31});
    EXPECT_EQ(EscLineAddress::fromWire(u"0"), EscLineAddress::master());
    for (const QStringView text : {u"", u"20", u"21", u"0x1", u" 1", u"+1", u"001"})
        EXPECT_FALSE(EscLineAddress::fromWire(text)) << text.toString().toStdString();
}

TEST(EscLineAddress, IsAPlaceAndBack)
{
    EXPECT_EQ(EscLineAddress{0x12}.node(), NodeId("esc:12"));
    EXPECT_EQ(EscLineAddress{31}.node(), NodeId("esc:1F"));
    EXPECT_EQ(EscLineAddress::of(NodeId("esc:1F")), EscLineAddress{31});
    EXPECT_EQ(addressTyped(u"esc:12"), EscLineAddress{0x12});
    EXPECT_EQ(addressTyped(u"1f"), EscLineAddress{31});
    EXPECT_FALSE(addressTyped(u"1.0"));
}

} // namespace
} // namespace codewheel
