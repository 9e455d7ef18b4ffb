// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/cam_bars.h"
#include "tests/report/report_example.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

const char *const heading = "1.0: FRABA OCD-IB K3, Crane 1, hoist";

CamProgram program(unsigned number, const Cam &cam0)
{
    CamProgram program{.number = number};
    program.cam[0] = cam0;
    return program;
}

std::vector<CamPicture> picturesOf(const ReportInput &input)
{
    std::vector<CamPicture> pictures;
    const Report report = reportOf(input);
    for (const ReportBlock &block : sectionOf(report, heading).blocks)
        if (const auto *picture = std::get_if<CamPicture>(&block))
            pictures.push_back(*picture);
    return pictures;
}

TEST(ReportedCams, WantedAndKnownStandSideBySide)
{
    ReportInput input = exampleInput();
    fraba(input).wantedCams = {program(1, {100, 200, true})};
    fraba(input).storedCams = {{program(1, {100, 300, true}), Evidence::read, input.now}};
    const Report report = reportOf(input);
    EXPECT_THAT(rowsOf(sectionOf(report, heading)),
                Contains("0 | 100 to 200, active | 100 to 300, active | differs"));
    EXPECT_THAT(rowsOf(sectionOf(report, heading)), Contains("1 | not set | not set | as wanted"));
    EXPECT_THAT(rowsOf(sectionOf(report, "Deviations")),
                Contains("1.0 | Crane 1, hoist | Cam program 1: stop of cam 0 | 200 | 300 | read"));
    const std::vector<CamPicture> pictures = picturesOf(input);
    ASSERT_EQ(pictures.size(), 2U);
    EXPECT_EQ(pictures[0].title, QStringLiteral("Cam program 1, wanted"));
    EXPECT_EQ(pictures[1].title, QStringLiteral("Cam program 1, known: read, 1 Mar 2026 14:00:00"));
}

TEST(ReportedCams, OnePictureIsEnoughWhereBothAgree)
{
    ReportInput input = exampleInput();
    fraba(input).wantedCams = {program(2, {100, 200, true})};
    fraba(input).storedCams = {{program(2, {100, 200, true}), Evidence::echoed, input.now}};
    const std::vector<CamPicture> pictures = picturesOf(input);
    ASSERT_EQ(pictures.size(), 1U);
    EXPECT_EQ(pictures[0].title,
              QStringLiteral("Cam program 2, as wanted, known: confirmed, 1 Mar 2026 14:00:00"));
}

TEST(ReportedCams, ActiveCamsAreToldAsBits)
{
    ReportInput input = exampleInput();
    fraba(input).wantedCams = {program(1, {100, 200, true})};
    fraba(input).storedCams = {{program(1, {100, 200, false}), Evidence::read, input.now}};
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), "Deviations")),
                Contains(HasSubstr("Cam program 1: active cams 7 to 0 | 00000001 | 00000000")));
}

TEST(ReportedCams, HysteresisAndPolarityDiffer)
{
    ReportInput input = exampleInput();
    fraba(input).wantedCams = {program(1, {100, 200, true, 3, true})};
    fraba(input).storedCams = {{program(1, {100, 200, true}), Evidence::read, input.now}};
    const Report report = reportOf(input);
    EXPECT_THAT(rowsOf(sectionOf(report, heading)),
                Contains("0 | 100 to 200, active, hysteresis 3, inverted | 100 to 200, active | differs"));
    EXPECT_THAT(
        rowsOf(sectionOf(report, "Deviations")),
        IsSupersetOf({"1.0 | Crane 1, hoist | Cam program 1: hysteresis of cam 0 | 3 | 0 | read",
                      "1.0 | Crane 1, hoist | Cam program 1: inverted cams 7 to 0 | 00000001 | 00000000 "
                      "| read"}));
}

TEST(ReportedCams, WhatIsUnknownIsSaidToBe)
{
    ReportInput input = exampleInput();
    fraba(input).wantedCams = {program(1, {100, 200, true})};
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), heading)), Contains("0 | 100 to 200, active | unknown | "));
}

TEST(ReportedCams, ProgramsWithNothingInThemAreOneSentence)
{
    ReportInput input = exampleInput();
    fraba(input).storedCams = {{CamProgram{.number = 3}, Evidence::read, input.now},
                               {CamProgram{.number = 4}, Evidence::read, input.now}};
    EXPECT_TRUE(picturesOf(input).empty());
    EXPECT_THAT(paragraphsOf(sectionOf(reportOf(input), heading)),
                Contains("Cam programs in which nothing is set: 3, 4."));
}

TEST(ReportedCams, PictureHasTheTotalRangeWhereItIsKnown)
{
    ReportInput input = exampleInput();
    fraba(input).wantedCams = {program(1, {100, 200, true})};
    EXPECT_THAT(picturesOf(input).front().lastText.toStdString(),
                HasSubstr("200, the largest position of a cam; the total range is unknown"));
    replaceValue(fraba(input).wanted, {Parameter::revolutions, 4096});
    EXPECT_EQ(picturesOf(input).front().positions, 4096);
    EXPECT_EQ(picturesOf(input).front().lastText, QStringLiteral("4095"));
}

TEST(CamBars, LastPositionBelongsToTheCam)
{
    const CamPicture picture{{}, program(1, {0, 49, true}), 100, {}, {}};
    EXPECT_THAT(camBars(picture), ElementsAre(CamBar{0, 0.0, 0.5, true}));
}

TEST(CamBars, ACamThroughZeroHasTwo)
{
    const CamPicture picture{{}, program(1, {75, 24, false}), 100, {}, {}};
    EXPECT_THAT(camBars(picture), ElementsAre(CamBar{0, 0.0, 0.25, false}, CamBar{0, 0.75, 1.0, false}));
}

TEST(CamBars, AnInvertedCamIsOnOutside)
{
    const auto barsOf = [](const Cam &cam) { return camBars({{}, program(1, cam), 100, {}, {}}); };
    EXPECT_THAT(barsOf({25, 74, true, 0, true}),
                ElementsAre(CamBar{0, 0.0, 0.25, true}, CamBar{0, 0.75, 1.0, true}));
    EXPECT_THAT(barsOf({0, 74, true, 0, true}), ElementsAre(CamBar{0, 0.75, 1.0, true}));
    EXPECT_THAT(barsOf({75, 24, true, 0, true}), ElementsAre(CamBar{0, 0.25, 0.75, true}));
}

TEST(CamBars, NothingIsDrawnBesideTheRange)
{
    const CamPicture picture{{}, program(1, {50, 500, true}), 100, {}, {}};
    EXPECT_THAT(camBars(picture), ElementsAre(CamBar{0, 0.5, 1.0, true}));
}

} // namespace
} // namespace codewheel
