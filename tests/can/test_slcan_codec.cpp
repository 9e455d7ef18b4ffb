// SPDX-License-Identifier: GPL-3.0-or-later
// SLCAN as Lawicel documents it (CAN232 and CANUSB manuals), in literal bytes.
#include "can/slcan_codec.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

SlcanItem frameItem(std::uint32_t id, std::vector<std::uint8_t> data, std::optional<int> stamp = {})
{
    SlcanItem item{.kind = SlcanItem::Kind::frame, .stamp = stamp};
    item.frame.id = id;
    item.frame.length = static_cast<std::uint8_t>(data.size());
    std::ranges::copy(data, item.frame.bytes.begin());
    return item;
}

SlcanItem extendedItem(SlcanItem item)
{
    item.frame.isExtended = true;
    return item;
}

SlcanItem remoteItem(SlcanItem item, std::uint8_t length)
{
    item.frame.isRemote = true;
    item.frame.length = length;
    return item;
}

SlcanItem textItem(const char *said)
{
    return {.kind = SlcanItem::Kind::text, .text = said};
}

const SlcanItem doneItem{.kind = SlcanItem::Kind::done};
const SlcanItem sentItem{.kind = SlcanItem::Kind::sent};
const SlcanItem refusedItem{.kind = SlcanItem::Kind::refused};

struct SlcanRow
{
    QByteArray bytes;
    std::vector<SlcanItem> items;
    std::uint64_t skipped = 0;
};

const std::vector<SlcanRow> slcanRows{
    {"t18528813\r", {frameItem(0x185, {0x88, 0x13})}},
    {"t0000\r", {frameItem(0, {})}},
    {"t7ff81122334455667788\r", {frameItem(0x7FF, {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88})}},
    {"T0CFFE0E02ABCD\r", {extendedItem(frameItem(0xCFF'E0E0, {0xAB, 0xCD}))}},
    {"T1FFFFFFF0\r", {extendedItem(frameItem(0x1FFF'FFFF, {}))}},
    {"r7018\r", {remoteItem(frameItem(0x701, {}), 8)}},
    {"R000001230\r", {extendedItem(remoteItem(frameItem(0x123, {}), 0))}},
    // with ms
    {"t18528813EA5F\r", {frameItem(0x185, {0x88, 0x13}, 59'999)}},
    {"t185288130000\r", {frameItem(0x185, {0x88, 0x13}, 0)}},
    {"t18528813EA60\r", {frameItem(0x185, {0x88, 0x13})}}, // there is no such ms
    {"r701012AB\r", {remoteItem(frameItem(0x701, {}, 0x12AB), 0)}},
    // answers
    {"\r", {doneItem}},
    {"z\r", {sentItem}},
    {"Z\r", {sentItem}},
    {"\a", {refusedItem}},
    {"\a\a\r", {refusedItem, refusedItem, doneItem}},
    {"V1013\rNA123\rF20\r", {textItem("V1013"), textItem("NA123"), textItem("F20")}},
    {"CANable-b158aa7\r", {textItem("CANable-b158aa7")}},
    // ends of lines
    {"z\nz\n\n", {sentItem, sentItem, doneItem}},
    {"z\r\n\r\nt0000\r\n", {sentItem, doneItem, frameItem(0, {})}},
    // torn and disturbed
    {"t1852881\r", {textItem("t1852881")}},
    {"t185288131\r", {textItem("t185288131")}},
    {"t9002AABB\r", {textItem("t9002AABB")}}, // more than 11 bits
    {"T200000000\r", {textItem("T200000000")}},
    {"t1859112233445566778899\r", {textItem("t1859112233445566778899")}},
    {"t1852\xFF\xFE\rz\r", {sentItem}, 7},
    {"t1852\az\r", {refusedItem, sentItem}, 5},
    {QByteArray(300, 'x') + "\rz\r", {sentItem}, 300},
};

TEST(SlcanCodec, TakesApartWhatAnAdapterSends)
{
    for (const SlcanRow &row : slcanRows) {
        SlcanReader reader;
        EXPECT_EQ(reader.read(row.bytes), row.items) << row.bytes.toStdString();
        EXPECT_EQ(reader.skipped(), row.skipped) << row.bytes.toStdString();
    }
}

TEST(SlcanCodec, WhatIsTornAcrossReadsIsPutTogether)
{
    for (const SlcanRow &row : slcanRows) {
        SlcanReader reader;
        std::vector<SlcanItem> items;
        for (const char byte : row.bytes)
            for (const SlcanItem &item : reader.read(QByteArray(1, byte)))
                items.push_back(item);
        EXPECT_EQ(items, row.items) << row.bytes.toStdString();
        EXPECT_EQ(reader.skipped(), row.skipped) << row.bytes.toStdString();
    }
}

TEST(SlcanCodec, WritesFrames)
{
    EXPECT_EQ(slcanCommand({.id = 0x60C, .length = 8, .bytes = {0x40, 0x18, 0x10, 0x01}}),
              "t60C84018100100000000\r");
    EXPECT_EQ(slcanCommand({.id = 0x1AB, .length = 0}), "t1AB0\r");
    EXPECT_EQ(slcanCommand({.id = 0x70C, .isRemote = true, .length = 1}), "r70C1\r");
    EXPECT_EQ(slcanCommand({.id = 0x1, .isExtended = true, .length = 1, .bytes = {0xFE}}), "T000000011FE\r");
    EXPECT_EQ(slcanCommand({.id = 0x1FFF'FFFF, .isExtended = true, .isRemote = true}), "R1FFFFFFF0\r");
}

TEST(SlcanCodec, HasNineRates)
{
    EXPECT_EQ(slcanRateCommand(10'000), "S0\r");
    EXPECT_EQ(slcanRateCommand(20'000), "S1\r");
    EXPECT_EQ(slcanRateCommand(50'000), "S2\r");
    EXPECT_EQ(slcanRateCommand(100'000), "S3\r");
    EXPECT_EQ(slcanRateCommand(125'000), "S4\r");
    EXPECT_EQ(slcanRateCommand(250'000), "S5\r");
    EXPECT_EQ(slcanRateCommand(500'000), "S6\r");
    EXPECT_EQ(slcanRateCommand(800'000), "S7\r");
    EXPECT_EQ(slcanRateCommand(1'000'000), "S8\r");
    EXPECT_EQ(slcanRateCommand(83'300), "");
}

TEST(SlcanCodec, KnowsTextsByTheirForm)
{
    EXPECT_TRUE(isLawicelVersion("V1013"));
    EXPECT_FALSE(isLawicelVersion("v1013"));
    EXPECT_FALSE(isLawicelVersion("V101"));
    EXPECT_FALSE(isLawicelVersion("V10A3"));
    EXPECT_FALSE(isLawicelVersion("CANable"));
    EXPECT_EQ(slcanStatusBits("FA4"), 0xA4);
    EXPECT_FALSE(slcanStatusBits("F0"));
    EXPECT_FALSE(slcanStatusBits("FXX"));
    EXPECT_TRUE(hasWords("CAN Init OK!"));
    EXPECT_FALSE(hasWords("852AABBt123"));
}

} // namespace
} // namespace codewheel
