// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/frame_meaning.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

std::string meaningOf(const CanFrame &frame)
{
    return CanFrameMeanings().next(frame)().toStdString();
}

TEST(FrameMeaning, ErrorsAreNamed)
{
    EXPECT_EQ(meaningOf({.id = 0x40, .isError = true}), "Error frame: bus off");
    EXPECT_EQ(meaningOf({.id = 0x88, .isError = true}), "Error frame: protocol violated, bus error");
    EXPECT_EQ(meaningOf({.isError = true}), "Error frame");
}

// SICK AHM36 as delivered, and a request to one node.
TEST(FrameMeaning, TheHeadOfJ1939IsTold)
{
    EXPECT_EQ(meaningOf({.id = 0x0CFFE0E0, .isExtended = true}), "J1939: priority 3, PGN FFE0h, from E0h");
    EXPECT_EQ(meaningOf({.id = 0x18EA12F9, .isExtended = true}),
              "J1939: priority 6, PGN EA00h, from F9h to 12h");
}

TEST(FrameMeaning, KindsOfBusAreAsked)
{
    EXPECT_EQ(meaningOf({.id = 0x185, .length = 4}), "Node 5: TPDO1");
    EXPECT_EQ(meaningOf({.id = 0x7FF}), "");
}

} // namespace
} // namespace codewheel
