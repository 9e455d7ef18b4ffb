// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_states.h"
#include "kinds/interbus/words/k3_cam_word.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct CoverRow
{
    const char *name;
    Cam cam;
    std::int64_t position;
    bool on;
};

class CamOnARing : public testing::TestWithParam<CoverRow>
{};

TEST_P(CamOnARing, IsOnFromStartToStopBothIncluded)
{
    const auto &[name, cam, position, on] = GetParam();
    EXPECT_EQ(isOn(cam, position), on);
    EXPECT_EQ(covers(cam, position), on);
    EXPECT_FALSE(isOn({cam.start, cam.stop, false}, position)) << "a cam that is not active";
}

constexpr std::int64_t largest = 33'554'431;

// FRABA manual 5.4.4: cam 3 from 15h to 213h; start > stop goes through zero
INSTANTIATE_TEST_SUITE_P(
    Manual544, CamOnARing,
    testing::Values(CoverRow{"before", {0x15, 0x213, true}, 0x14, false},
                    CoverRow{"atStart", {0x15, 0x213, true}, 0x15, true},
                    CoverRow{"between", {0x15, 0x213, true}, 0x100, true},
                    CoverRow{"atStop", {0x15, 0x213, true}, 0x213, true},
                    CoverRow{"behind", {0x15, 0x213, true}, 0x214, false},
                    CoverRow{"onePosition", {7, 7, true}, 7, true},
                    CoverRow{"besideOnePosition", {7, 7, true}, 8, false},
                    CoverRow{"throughZeroAtStart", {0x213, 0x15, true}, 0x213, true},
                    CoverRow{"throughZeroAtTheEnd", {0x213, 0x15, true}, largest, true},
                    CoverRow{"throughZeroAtZero", {0x213, 0x15, true}, 0, true},
                    CoverRow{"throughZeroAtStop", {0x213, 0x15, true}, 0x15, true},
                    CoverRow{"throughZeroOutside", {0x213, 0x15, true}, 0x16, false},
                    CoverRow{"throughZeroOutsideBeforeStart", {0x213, 0x15, true}, 0x212, false},
                    CoverRow{"all", {0, largest, true}, largest, true}),
    [](const auto &row) { return row.param.name; });

// Checks all stretches of a small ring at each of their positions.
TEST(CamOnAStretch, IsKnownWhereAllOfItsPositionsAgree)
{
    constexpr std::int64_t total = 7;
    for (std::int64_t start = 0; start < total; ++start)
        for (std::int64_t stop = 0; stop < total; ++stop)
            for (std::int64_t first = 0; first < total; ++first)
                for (std::int64_t last = first; last < total; ++last) {
                    const Cam cam{start, stop, true};
                    std::int64_t on = 0;
                    for (std::int64_t position = first; position <= last; ++position)
                        on += isOn(cam, position) ? 1 : 0;
                    const auto expected = on == 0                  ? std::optional(false)
                                          : on == last - first + 1 ? std::optional(true)
                                                                   : std::nullopt;
                    EXPECT_EQ(isOn(cam, first, last), expected)
                        << start << " to " << stop << " at " << first << " to " << last;
                    EXPECT_EQ(isOn({start, stop, false}, first, last), false) << "not active";
                }
}

// FRABA manual 5.4.4: 20400093h is cams 0, 1, 4 and 7
TEST(CamStates, BitNIsCamN)
{
    CamProgram program;
    for (const std::size_t n : {0U, 1U, 4U, 7U})
        program.cam[n] = {100, 200, true};
    program.cam[2] = {100, 200, false};
    program.cam[7].stop = 150;
    EXPECT_EQ(activeCams(program), 0x93);
    EXPECT_EQ(states(program, 99), 0x00);
    EXPECT_EQ(states(program, 100), 0x93);
    EXPECT_EQ(states(program, 151), 0x13);
}

struct WordRow
{
    unsigned shift;
    std::int64_t position;
    Word in;
};

// Literal words: D7..D0 the cams, D24..D8 = (position >> shift) & 1FFFFh, D31..D25 = 0
TEST(CamWord, HoldsTheCamsAndAPartOfThePosition)
{
    CamProgram program;
    program.cam[3] = {0x15, 0x1FF'FFFF, true};
    const WordRow rows[] = {
        {0, 0x0000014, 0x0000'1400},  {0, 0x0000015, 0x0000'1508},  {0, 0x1FFFFFF, 0x01FF'FF08},
        {8, 0x1FFFFFF, 0x01FF'FF08},  {8, 0x1234567, 0x0123'4508},  {0, 0x1234567, 0x0145'6708},
        {24, 0x1FFFFFF, 0x0000'0108}, {25, 0x1FFFFFF, 0x0000'0008},
    };
    for (const WordRow &row : rows) {
        program.shift = row.shift;
        EXPECT_EQ(k3::camWord(states(program, row.position), static_cast<Word>(row.position >> row.shift)),
                  row.in)
            << "shift " << row.shift << ", " << row.position;
    }
}

TEST(CamStates, OfAnInvertedCamAreOutsideOfItsPositions)
{
    const Cam cam{10, 20, true, 0, true};
    for (const std::int64_t position : {9, 21})
        EXPECT_TRUE(isOn(cam, position)) << position;
    for (const std::int64_t position : {10, 20})
        EXPECT_FALSE(isOn(cam, position)) << position;
    EXPECT_FALSE(isOn({10, 20, false, 0, true}, 9)) << "it is not active";
}

TEST(CamStates, WithinTheHysteresisDependOnTheWay)
{
    const Cam cam{10, 20, true, 2, false};
    EXPECT_EQ(isOn(cam, 7, 7), false);
    EXPECT_EQ(isOn(cam, 8, 8), std::nullopt);
    EXPECT_EQ(isOn(cam, 11, 11), std::nullopt);
    EXPECT_EQ(isOn(cam, 12, 18), true);
    EXPECT_EQ(isOn(cam, 19, 19), std::nullopt);
    EXPECT_EQ(isOn(cam, 23, 23), false);
    EXPECT_EQ(isOn({10, 20, true, 2, true}, 15, 15), false) << "inverted";
}

} // namespace
} // namespace codewheel
