// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_map.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"

#include <gtest/gtest.h>
#include <set>

namespace codewheel {
namespace {

using namespace test;

GatewayMap mapOf(const std::vector<GatewayDevice> &ring, const GatewaySettings &settings = {})
{
    return GatewayMap::of(structureOf(ring), settings).value();
}

TEST(GatewayMap, AK3HasTwoRegistersInEachDirection)
{
    const GatewayMap map = mapOf(k3Ring(2), {.inFirst = 100, .outFirst = 200});
    EXPECT_EQ(map.in(0), (RegisterBlock{100, 2}));
    EXPECT_EQ(map.in(1), (RegisterBlock{102, 2}));
    EXPECT_EQ(map.out(1), (RegisterBlock{202, 2}));
}

TEST(GatewayMap, TheWordIsHighRegisterFirstUnlessSetOtherwise)
{
    const std::vector<Register> registers{0x0200, 0x00FF};
    EXPECT_EQ(mapOf(k3Ring(1)).word(registers), 0x0200'00FFu);
    EXPECT_EQ(mapOf(k3Ring(1), {.highWordFirst = false}).word(registers), 0x00FF'0200u);
    std::vector<Register> put(2);
    mapOf(k3Ring(1)).put(0x0200'00FF, put);
    EXPECT_EQ(put, registers);
}

TEST(GatewayMap, ADeviceOfSixteenBitsHasThemInTheLowHalf)
{
    const std::vector<Register> registers{0xABCD};
    EXPECT_EQ(mapOf({deviceAt(1, 1, 1)}).word(registers), 0x0000'ABCDu);
}

// 64 K3 are 128 registers: one transaction holds 125 to read and 123 to write, so 62 and 61 devices.
TEST(GatewayMap, AWholeImageTakesAsFewTransactionsAsTheProtocolAllows)
{
    const GatewayMap map = mapOf(k3Ring(64));
    EXPECT_EQ(map.inBlocks(), (std::vector<RegisterBlock>{{0, 124}, {124, 4}}));
    EXPECT_EQ(map.outBlocks(), (std::vector<RegisterBlock>{{0, 122}, {122, 6}}));
    const GatewayMap with23 =
        mapOf(k3Ring(64), {.inArea = RegisterArea::holding, .inFirst = 1'000, .writesWithRead = true});
    EXPECT_EQ(with23.outBlocks(), (std::vector<RegisterBlock>{{0, 120}, {120, 8}}));
}

TEST(GatewayMap, NoWordIsSplitBetweenTwoTransactions)
{
    for (int devices = 1; devices <= 128; ++devices) {
        const GatewayMap map = mapOf(k3Ring(devices));
        for (const auto *blocks : {&map.inBlocks(), &map.outBlocks(), &map.readBackBlocks()}) {
            int moved = 0;
            for (const RegisterBlock &block : *blocks) {
                EXPECT_EQ(block.first % 2, 0);
                EXPECT_EQ(block.count % 2, 0);
                moved += block.count;
            }
            EXPECT_EQ(moved, 2 * devices);
        }
    }
}

TEST(GatewayMap, NoTwoReadsHaveTheSameLength)
{
    for (int devices = 1; devices <= 128; ++devices) {
        const GatewayMap map = mapOf(k3Ring(devices));
        std::set<int> lengths;
        for (const RegisterBlock &block : map.inBlocks())
            EXPECT_TRUE(lengths.insert(block.count).second) << devices;
    }
}

TEST(GatewayMap, WhatIsBehindThirtyTwoBitsOfADeviceIsReadOverAndNeverWritten)
{
    const GatewayMap map = mapOf({k3At(1), deviceAt(2, 4, 4), k3At(3)});
    EXPECT_EQ(map.in(2), (RegisterBlock{6, 2}));
    EXPECT_EQ(map.inBlocks(), (std::vector<RegisterBlock>{{0, 8}}));
    EXPECT_EQ(map.outBlocks(), (std::vector<RegisterBlock>{{0, 4}, {6, 2}}));
}

TEST(GatewayMap, DevicesWithoutWordsTakeNoRegisters)
{
    const GatewayMap map = mapOf({deviceAt(1, 0, 0), deviceAt(2, 2, 0), k3At(3)});
    EXPECT_EQ(map.in(0).count, 0);
    EXPECT_EQ(map.in(2), (RegisterBlock{2, 2}));
    EXPECT_EQ(map.out(2), (RegisterBlock{0, 2}));
}

TEST(GatewayMap, AreasThatOverlapOrEndTooFarAreRefused)
{
    const RingStructure ring = structureOf(k3Ring(4));
    const auto refused = [&](const GatewaySettings &settings) {
        const auto map = GatewayMap::of(ring, settings);
        return !map && map.error().id == GatewayRefusalId::registerMapWrong;
    };
    EXPECT_FALSE(refused({}));
    EXPECT_TRUE(refused({.inArea = RegisterArea::holding}));
    EXPECT_TRUE(refused({.inArea = RegisterArea::holding, .inFirst = 7}));
    EXPECT_FALSE(refused({.inArea = RegisterArea::holding, .inFirst = 8}));
    EXPECT_TRUE(refused({.writesWithRead = true}));
    EXPECT_TRUE(refused({.inFirst = 65'529}));
    EXPECT_FALSE(refused({.inFirst = 65'528}));
    EXPECT_TRUE(refused({.outFirst = 65'530}));
    EXPECT_TRUE(refused({.controlRegister = 7}));
    EXPECT_FALSE(refused({.controlRegister = 8}));
}

// 61 and 100 are met.
TEST(GatewayMap, KeepsToTheLimitsOfTheGateway)
{
    const auto map = GatewayMap::of(structureOf(k3Ring(64)), {.mostRead = 61, .mostWritten = 100});
    ASSERT_TRUE(map);
    int read = 0;
    for (const RegisterBlock &block : map->inBlocks()) {
        EXPECT_LE(block.count, 61);
        EXPECT_EQ(block.count % 2, 0) << "no word is split";
        read += block.count;
    }
    EXPECT_EQ(read, 128);
    for (const RegisterBlock &block : map->readBackBlocks())
        EXPECT_LE(block.count, 61);
    ASSERT_EQ(map->outBlocks().size(), 2u);
    EXPECT_LE(map->outBlocks().front().count, 100);
}

TEST(GatewayMap, WritesOnlyTheDevicesThatAreAskedFor)
{
    const auto map = GatewayMap::of(structureOf(k3Ring(4)), {});
    ASSERT_TRUE(map);
    EXPECT_EQ(map->outBlocksOf({false, true, true, false}), (std::vector<RegisterBlock>{{2, 4}}));
    EXPECT_EQ(map->outBlocksOf({true, false, false, true}), (std::vector<RegisterBlock>{{0, 2}, {6, 2}}));
    EXPECT_TRUE(map->outBlocksOf({false, false, false, false}).empty());
}

} // namespace
} // namespace codewheel
