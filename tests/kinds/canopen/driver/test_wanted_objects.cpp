// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/canopen/driver/wanted_objects.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using canopen::WantedObject;
using canopen::wantedObjects;

class WantedObjects : public testing::Test
{
protected:
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &device = *catalog.find(QStringLiteral("canopen-406-multi-turn"));
};

TEST_F(WantedObjects, AValueIsThatOfItsObject)
{
    const auto wanted = wantedObjects(device, {{Parameter::steps, 4096}}, {});
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted.front(), (WantedObject{{0x6001, 0}, {std::int64_t{4096}}, 0}));
    EXPECT_TRUE(wanted.front().isMetBy({std::int64_t{4096}}));
    EXPECT_FALSE(wanted.front().isMetBy({std::int64_t{8192}}));
}

// CiA 406: bit 0 of 6000h is the direction, bit 2 the scaling.
TEST_F(WantedObjects, BitsOfOneObjectAreWantedTogetherAndTheOthersMayBeAnything)
{
    const auto wanted = wantedObjects(device, {{Parameter::direction, 1}, {Parameter::scaling, 1}}, {});
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted.front().bits, 0b101U);
    EXPECT_TRUE(wanted.front().isMetBy({std::int64_t{0b101}}));
    EXPECT_TRUE(wanted.front().isMetBy({std::int64_t{0b111}}));
    EXPECT_FALSE(wanted.front().isMetBy({std::int64_t{0b001}}));
}

TEST_F(WantedObjects, ACamIsSeveralObjects)
{
    CamProgram program;
    program.cam[1] = {.start = 100, .stop = -1};
    const auto wanted = wantedObjects(device, {}, {program});
    const auto found = std::ranges::find(wanted, canopen::SdoObject{0x6321, 1}, &WantedObject::object);
    ASSERT_NE(found, wanted.end());
    EXPECT_TRUE(found->isMetBy({std::int64_t{-1}}));
    EXPECT_TRUE(found->isMetBy({std::int64_t{0xFFFF'FFFF}})) << "the same octets";
    EXPECT_FALSE(found->isMetBy({std::int64_t{1}}));
}

TEST_F(WantedObjects, WhatHasNoObjectIsLeftOut)
{
    EXPECT_TRUE(wantedObjects(device, {{Parameter::rodLength, 1}}, {}).empty());
}

} // namespace
} // namespace codewheel
