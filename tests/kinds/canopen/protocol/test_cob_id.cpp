// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/cob_id.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

using Service = CobId::Service;

struct CobRow
{
    std::uint32_t identifier;
    CobId cob;
};

// CiA 301, predefined connection set; CiA 305.
const CobRow cobRows[] = {
    {0x000, {Service::nmt}},
    {0x080, {Service::sync}},
    {0x081, {Service::emcy, 1}},
    {0x0FF, {Service::emcy, 127}},
    {0x100, {Service::time}},
    {0x181, {Service::tpdo, 1, 1}},
    {0x1FF, {Service::tpdo, 127, 1}},
    {0x201, {Service::rpdo, 1, 1}},
    {0x285, {Service::tpdo, 5, 2}},
    {0x305, {Service::rpdo, 5, 2}},
    {0x385, {Service::tpdo, 5, 3}},
    {0x405, {Service::rpdo, 5, 3}},
    {0x485, {Service::tpdo, 5, 4}},
    {0x505, {Service::rpdo, 5, 4}},
    {0x585, {Service::sdoAnswer, 5}},
    {0x605, {Service::sdoRequest, 5}},
    {0x705, {Service::errorControl, 5}},
    {0x77F, {Service::errorControl, 127}},
    {0x7E4, {Service::lssAnswer}},
    {0x7E5, {Service::lssRequest}},
};

TEST(CobId, ThePredefinedConnectionSet)
{
    for (const CobRow &row : cobRows)
        EXPECT_EQ(CobId::of(row.identifier), row.cob) << std::hex << row.identifier;
    for (const CobRow &row : cobRows)
        EXPECT_EQ(row.cob.identifier(), row.identifier);
}

TEST(CobId, WhatIsNotInIt)
{
    for (const std::uint32_t identifier : {0x001U, 0x07FU, 0x101U, 0x180U, 0x200U, 0x580U, 0x600U, 0x680U,
                                           0x6FFU, 0x700U, 0x780U, 0x7E3U, 0x7E6U, 0x7FFU})
        EXPECT_FALSE(CobId::of(identifier)) << std::hex << identifier;
}

} // namespace
} // namespace codewheel::canopen
