// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/check_cams.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr CamAbilities k3Cams;
// A rod with the cams of a fieldbus profile: limits, hysteresis and polarity, one program, no circle.
constexpr CamAbilities rodCams{.programs = 1,
                               .cams = 4,
                               .isCyclic = false,
                               .hasMode = false,
                               .hasShift = false,
                               .hasHysteresis = true,
                               .hasPolarity = true};

Refusal badInput(RefusalCode id, std::vector<RefusalArgument> arguments)
{
    return {RefusalKind::badInput, id, std::move(arguments)};
}

TEST(CheckCams, TakesAllThatTheEncoderHasRoomFor)
{
    CamProgram program{.number = 8, .cam = {}, .shift = 25};
    program.cam[0] = {8191, 0, true};
    program.cam[7] = {0, 8191, false};
    EXPECT_TRUE(check(program, k3Cams, 8191));
    program.cam[7].stop = 33'554'431;
    EXPECT_TRUE(check(program, k3Cams)) << "25 bits, where the total range is not known";
}

TEST(CheckCams, NamesWhatIsOutOfRange)
{
    for (const unsigned number : {0U, 9U}) {
        const auto checked = check({.number = number, .cam = {}, .shift = 0}, k3Cams);
        ASSERT_FALSE(checked);
        EXPECT_EQ(checked.error(),
                  badInput(RefusalId::camProgramOutOfRange, {std::int64_t{number}, std::int64_t{8}}));
    }
    EXPECT_EQ(check({.number = 1, .cam = {}, .shift = 26}, k3Cams).error(),
              badInput(RefusalId::camShiftOutOfRange, {std::int64_t{26}}));

    CamProgram program;
    program.cam[5] = {0, 8192, false};
    EXPECT_EQ(
        check(program, k3Cams, 8191).error(),
        badInput(RefusalId::camPositionTooLarge, {std::int64_t{5}, std::int64_t{8192}, std::int64_t{8191}}));
    program.cam[5] = {-1, 0, false};
    EXPECT_EQ(
        check(program, k3Cams, 8191).error(),
        badInput(RefusalId::camPositionTooLarge, {std::int64_t{5}, std::int64_t{-1}, std::int64_t{8191}}));
}

TEST(CheckCams, AnEncoderTakesWhatItsCamsHave)
{
    CamProgram program;
    program.cam[3] = {100, 200, true, 5, true};
    EXPECT_TRUE(check(program, rodCams, 8191));
    EXPECT_EQ(check(program, k3Cams, 8191).error(), badInput(RefusalId::camHasMore, {std::int64_t{3}}));
    program.cam[3].isInverted = false;
    EXPECT_EQ(check(program, k3Cams, 8191).error(), badInput(RefusalId::camHasMore, {std::int64_t{3}}));
    program.cam[3].hysteresis = 0;
    EXPECT_TRUE(check(program, k3Cams, 8191));
    program.cam[3].isInverted = true;
    EXPECT_EQ(check(program, k3Cams, 8191).error(), badInput(RefusalId::camHasMore, {std::int64_t{3}}));
}

TEST(CheckCams, NamesWhatAnEncoderHasNot)
{
    EXPECT_EQ(check({.number = 2}, rodCams).error(),
              badInput(RefusalId::camProgramOutOfRange, {std::int64_t{2}, std::int64_t{1}}));
    EXPECT_EQ(check({.shift = 1}, rodCams).error(), badInput(RefusalId::camHasNoShift, {std::int64_t{1}}));
    CamProgram program;
    program.cam[4] = {0, 10, false};
    EXPECT_EQ(check(program, rodCams).error(),
              badInput(RefusalId::camOutOfRange, {std::int64_t{4}, std::int64_t{3}}));
    program.cam[4] = {};
    program.cam[0] = {10, 9, false};
    EXPECT_EQ(check(program, rodCams).error(), badInput(RefusalId::camThroughZero, {std::int64_t{0}}));
    program.cam[0] = {9, 10, false, 8192};
    EXPECT_EQ(
        check(program, rodCams, 8191).error(),
        badInput(RefusalId::camPositionTooLarge, {std::int64_t{0}, std::int64_t{8192}, std::int64_t{8191}}));
}

} // namespace
} // namespace codewheel
