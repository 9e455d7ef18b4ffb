// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/check_cams.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

Refusal badInput(RefusalId id, std::vector<RefusalArgument> arguments)
{
    return {RefusalKind::badInput, id, std::move(arguments)};
}

TEST(CheckCams, TakesAllThatTheEncoderHasRoomFor)
{
    CamProgram program{.number = 8, .cam = {}, .shift = 25};
    program.cam[0] = {8191, 0, true};
    program.cam[7] = {0, 8191, false};
    EXPECT_TRUE(check(program, 8191));
    program.cam[7].stop = 33'554'431;
    EXPECT_TRUE(check(program)) << "25 bits, where the total range is not known";
}

TEST(CheckCams, NamesWhatIsOutOfRange)
{
    for (const unsigned number : {0U, 9U}) {
        const auto checked = check({.number = number, .cam = {}, .shift = 0});
        ASSERT_FALSE(checked);
        EXPECT_EQ(checked.error(), badInput(RefusalId::camProgramOutOfRange, {std::int64_t{number}}));
    }
    EXPECT_EQ(check({.number = 1, .cam = {}, .shift = 26}).error(),
              badInput(RefusalId::camShiftOutOfRange, {std::int64_t{26}}));

    CamProgram program;
    program.cam[5] = {0, 8192, false};
    EXPECT_EQ(
        check(program, 8191).error(),
        badInput(RefusalId::camPositionTooLarge, {std::int64_t{5}, std::int64_t{8192}, std::int64_t{8191}}));
    program.cam[5] = {-1, 0, false};
    EXPECT_EQ(
        check(program, 8191).error(),
        badInput(RefusalId::camPositionTooLarge, {std::int64_t{5}, std::int64_t{-1}, std::int64_t{8191}}));
}

} // namespace
} // namespace codewheel
