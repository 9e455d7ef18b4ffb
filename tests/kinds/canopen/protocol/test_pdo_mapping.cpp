// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/pdo_mapping.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

// Reads the PDO from these objects; of the others the node has none.
struct Dictionary
{
    struct Row
    {
        SdoObject object;
        std::vector<std::uint8_t> value;
    };
    std::vector<Row> rows;

    std::vector<std::uint8_t> value(const SdoObject &object) const
    {
        for (const Row &each : rows)
            if (each.object == object)
                return each.value;
        return {};
    }
};

std::vector<std::uint8_t> octetsOf(std::uint32_t number)
{
    return {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8),
            static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 24)};
}

PdoMapping mappingWith(std::initializer_list<std::uint32_t> entries, std::uint32_t identifier = 0x40000185)
{
    PdoMapping mapping(1);
    mapping.take({0x1800, 1}, octetsOf(identifier));
    mapping.take({0x1A00, 0}, std::array{static_cast<std::uint8_t>(entries.size())});
    std::uint8_t sub = 0;
    for (const std::uint32_t entry : entries)
        mapping.take({0x1A00, ++sub}, octetsOf(entry));
    return mapping;
}

PdoType notSigned(const SdoObject &)
{
    return {};
}

std::vector<std::int64_t> numbersIn(const PdoMapping &mapping, std::string_view frame,
                                    const std::function<PdoType(const SdoObject &)> &typeOf = notSigned)
{
    std::vector<std::int64_t> numbers;
    for (const PdoValue &each : mapping.values(frameFrom(frame), typeOf))
        numbers.push_back(each.number);
    return numbers;
}

using Numbers = std::vector<std::int64_t>;

TEST(PdoMapping, ReadsWhatTheCountTells)
{
    const Dictionary dictionary{{{{0x1801, 1}, {0x85, 0x02, 0, 0}},
                                 {{0x1801, 2}, {1}},
                                 {{0x1801, 3}, {0x2C, 0x01}},
                                 {{0x1801, 5}, {0x64, 0}},
                                 {{0x1A01, 0}, {2}},
                                 {{0x1A01, 1}, {0x20, 0, 0x04, 0x60}},
                                 {{0x1A01, 2}, {0x10, 1, 0x30, 0x60}}}};
    PdoMapping mapping(2);
    EXPECT_EQ(mapping.missing(),
              (std::vector<SdoObject>{{0x1801, 1}, {0x1801, 2}, {0x1801, 3}, {0x1801, 5}, {0x1A01, 0}}));
    int reads = 0;
    while (!mapping.isRead() && ++reads < 10)
        EXPECT_TRUE(mapping.take(mapping.missing().front(), dictionary.value(mapping.missing().front())));
    EXPECT_EQ(reads, 7);
    EXPECT_TRUE(mapping.isThere());
    EXPECT_EQ(mapping.type(), 1);
    EXPECT_EQ(mapping.inhibitTime(), 30ms);
    EXPECT_EQ(mapping.eventTimer(), 100ms);
    EXPECT_FALSE(mapping.isOff());
    EXPECT_EQ(mapping.identifier(), 0x285);
    EXPECT_EQ(mapping.entries(), (std::vector<PdoEntry>{{{0x6004, 0}, 32, 0}, {{0x6030, 1}, 16, 32}}));
    EXPECT_FALSE(mapping.take({0x1800, 1}, octetsOf(1)));
}

TEST(PdoMapping, WhatTheNodeDoesNotHaveIsNotAskedAgain)
{
    PdoMapping mapping(1);
    while (!mapping.isRead())
        mapping.take(mapping.missing().front(), {});
    EXPECT_FALSE(mapping.isThere());
    EXPECT_TRUE(mapping.isOff());
}

TEST(PdoMapping, Identifiers)
{
    const PdoMapping off = mappingWith({0x60040020}, 0xC0000185);
    EXPECT_TRUE(off.isOff());
    EXPECT_FALSE(off.isOf(frameFrom("185# 88 13 00 00")));
    const PdoMapping other = mappingWith({0x60040020}, 0x000001A7);
    EXPECT_TRUE(other.isOf(frameFrom("1A7# 88 13 00 00")));
    EXPECT_FALSE(other.isOf(frameFrom("185# 88 13 00 00")));
    EXPECT_FALSE(other.isOf(frameFrom("1A7#R")));
    const PdoMapping extended = mappingWith({0x60040020}, 0x20012345);
    CanFrame frame = frameFrom("12345# 88 13 00 00");
    EXPECT_FALSE(extended.isOf(frame));
    frame.isExtended = true;
    EXPECT_TRUE(extended.isOf(frame));
}

TEST(PdoMapping, ThePositionOfThePage)
{
    EXPECT_EQ(numbersIn(mappingWith({0x60040020}), "185# 88 13 00 00"), Numbers{5000});
}

TEST(PdoMapping, SignsComeFromTheCaller)
{
    const PdoMapping mapping = mappingWith({0x60040020, 0x60300110});
    const auto speedIsSigned = [](const SdoObject &object) {
        return PdoType{.isSigned = object.index == 0x6030};
    };
    EXPECT_EQ(numbersIn(mapping, "185# FF FF FF FF FE FF", speedIsSigned), (Numbers{0xFFFFFFFF, -2}));
    EXPECT_EQ(numbersIn(mapping, "185# FF FF FF FF FE FF"), (Numbers{0xFFFFFFFF, 0xFFFE}));
}

TEST(PdoMapping, EntriesNeedNotBeWholeBytes)
{
    const PdoMapping mapping = mappingWith({0x63000101, 0x63000207, 0x60040018, 0x60300104});
    EXPECT_EQ(numbersIn(mapping, "185# 83 56 34 12 0F"), (Numbers{1, 0x41, 0x123456, 15}));
    EXPECT_EQ(numbersIn(mappingWith({0x20000040}), "185# FE FF FF FF FF FF FF FF",
                        [](const SdoObject &) { return PdoType{.isSigned = true}; }),
              Numbers{-2});
}

TEST(PdoMapping, DummiesLeaveRoom)
{
    const PdoMapping mapping = mappingWith({0x00050008, 0x00060010, 0x60040020});
    EXPECT_EQ(numbersIn(mapping, "185# 11 22 33 88 13 00 00"), Numbers{5000});
}

TEST(PdoMapping, FromAnEntryThatDoesNotFitItsObjectOnNothingIsRead)
{
    const auto sizes = [](const SdoObject &object) {
        return PdoType{.bits = object.index == 0x6004 ? 32 : 16};
    };
    const PdoMapping mapping = mappingWith({0x60300110, 0x60040010, 0x60300210});
    EXPECT_EQ(numbersIn(mapping, "185# 01 00 02 00 03 00", sizes), Numbers{1});
    // The fields the other way round: 20h bits of 0060h:04.
    EXPECT_EQ(numbersIn(mappingWith({0x20006004}), "185# 88 13 00 00", sizes), Numbers{});
    EXPECT_EQ(numbersIn(mappingWith({0x60040000}), "185# 88 13 00 00"), Numbers{});
    EXPECT_EQ(numbersIn(mappingWith({0x600400FF}), "185# 88 13 00 00 00 00 00 00"), Numbers{});
}

TEST(PdoMapping, AFrameThatIsTooShortSaysNothing)
{
    const PdoMapping mapping = mappingWith({0x60040020, 0x60300110});
    EXPECT_EQ(numbersIn(mapping, "185# 88 13 00 00 01"), Numbers{});
    EXPECT_EQ(numbersIn(mapping, "185# 88 13 00 00 01 00 00"), (Numbers{5000, 1}));
}

TEST(PdoMapping, WithoutAllEntriesNothingIsRead)
{
    PdoMapping mapping = mappingWith({0x60040020});
    mapping.take({0x1A00, 0}, std::array<std::uint8_t, 1>{2});
    EXPECT_EQ(numbersIn(mapping, "185# 88 13 00 00 00 00"), Numbers{});
    mapping.take({0x1A00, 0}, std::array<std::uint8_t, 1>{0xFE}); // multiplexed
    EXPECT_TRUE(mapping.entries().empty());
}

} // namespace
} // namespace codewheel::canopen
