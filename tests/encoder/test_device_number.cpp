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

TEST(DeviceNumber, AnythingElseIsNoDeviceNumber)
{
    for (const QStringView text :
         {u"", u"1", u"1.", u".0", u"0.0", u"+1.0", u"1.0 ", u"1,0", u"-1.0", u"1.0.0", u"1234.0"})
        EXPECT_FALSE(DeviceNumber::parse(text)) << text.toString().toStdString();
}

} // namespace
} // namespace codewheel
