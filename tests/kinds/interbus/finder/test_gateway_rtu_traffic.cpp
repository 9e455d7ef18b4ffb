// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/finder/gateway_rtu_traffic.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

QByteArray hex(const char *digits)
{
    return QByteArray::fromHex(digits);
}

TEST(RtuTraffic, CountsRequestsAnswersAndExceptions)
{
    EXPECT_EQ(rtuFramesIn(hex("01040000000131ca")), 1);                // function 4
    EXPECT_EQ(rtuFramesIn(hex("01040000000131ca 0104021234b447")), 2); // and its answer
    EXPECT_EQ(rtuFramesIn(hex("010300000001840a 0103020007f986 0184 02c2c1")), 3);
    EXPECT_EQ(rtuFramesIn(hex("ff00 010300000001840a 77")), 1) << "among noise";
    EXPECT_EQ(rtuFramesIn(hex("010300000001840b")), 0) << "a wrong CRC";
    EXPECT_EQ(rtuFramesIn(hex("0103000000018")), 0) << "half of one";
    EXPECT_EQ(rtuFramesIn({}), 0);
}

TEST(RtuTraffic, NoiseIsNoFrame)
{
    quint32 state = 1;
    QByteArray noise;
    for (int i = 0; i < 100'000; ++i) {
        state = state * 1'664'525U + 1'013'904'223U;
        noise += static_cast<char>(state >> 24U);
    }
    EXPECT_LE(rtuFramesIn(noise), 1);
}

TEST(RtuTraffic, FindsTheAnswerOfTheUnitThatWasAsked)
{
    const auto answer = rtuAnswerIn(hex("01040000000131ca 0104021234b447"), 1, 4); // behind its echo
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->exception, 0);
    EXPECT_EQ(answer->value, 0x1234);
    const auto refused = rtuAnswerIn(hex("018402c2c1"), 1, 4);
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->exception, 2);
    EXPECT_FALSE(rtuAnswerIn(hex("0204021234f047"), 1, 4)) << "another unit";
    EXPECT_FALSE(rtuAnswerIn(hex("0104021234b447"), 1, 3)) << "another function";
    EXPECT_FALSE(rtuAnswerIn(hex("0104021234b4"), 1, 4)) << "not all of it yet";
}

} // namespace
} // namespace codewheel
