// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_file.h"
#include "tests/support/breakage.h"
#include "vocabulary/refusal_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

// The example of docs/cam-files.md.
const QByteArray sound = R"({
  "format": "codewheel-cams",
  "version": 1,
  "device": "fraba-ocd-ib",
  "totalRange": 8192,
  "programs": [
    {
      "program": 1,
      "shift": 0,
      "cams": [
        {"cam": 3, "start": 21, "stop": 531, "active": true},
        {"cam": 7, "start": 8000, "stop": 100, "active": false}
      ]
    }
  ]
}
)";

const QString fileName = QStringLiteral("press.json");

TEST(CamFile, IsRead)
{
    const auto file = camFileFromJson(sound, fileName);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->device, QStringLiteral("fraba-ocd-ib"));
    EXPECT_EQ(file->totalRange, 8192);
    CamProgram program;
    program.cam[3] = {21, 531, true};
    program.cam[7] = {8000, 100, false};
    EXPECT_EQ(file->programs, std::vector{program});
}

TEST(CamFile, HoldsHysteresisAndPolarityWhereACamHasThem)
{
    CamProgram program;
    program.cam[3] = {21, 531, true, 4, true};
    const QByteArray json =
        camFileToJson({.device = QStringLiteral("rod"), .totalRange = {}, .programs = {program}});
    EXPECT_TRUE(json.contains(
        R"({"cam": 3, "start": 21, "stop": 531, "active": true, "hysteresis": 4, "inverted": true})"))
        << json.toStdString();
    EXPECT_TRUE(json.contains(R"({"cam": 4, "start": 0, "stop": 0, "active": false})"));
    const auto file = camFileFromJson(json, fileName);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->programs, std::vector{program});
}

class BrokenCamFile : public testing::TestWithParam<Breakage>
{};

TEST_P(BrokenCamFile, IsRefusedWithLineKeyAndReason)
{
    const auto file = camFileFromJson(brokenBy(GetParam(), sound), fileName);
    ASSERT_FALSE(file);
    expectNamed(GetParam(), file.error(), RefusalId::camFileBroken, fileName);
}

INSTANTIATE_TEST_SUITE_P(
    Rules, BrokenCamFile,
    testing::Values(
        Breakage{"\"version\": 1,", "\"version\": 1", 4, "", "not valid JSON"},
        Breakage{"codewheel-cams", "codewheel-sequence", 2, "format", "not a file of cam programs"},
        Breakage{"\"version\": 1,", "\"version\": 2,", 3, "version", "Only version 1"},
        Breakage{"\"version\": 1,", "\"version\": 1, \"version\": 1,", 3, "version", "is here twice"},
        Breakage{"\"device\": \"fraba-ocd-ib\",", "", 1, "device", "missing"},
        Breakage{"8192", "0", 5, "totalRange", "not between"},
        Breakage{"8192", "33554433", 5, "totalRange", "not between"},
        Breakage{"8192", "8192.5", 5, "totalRange", "whole number"},
        Breakage{"8192", "8192, \"note\": \"\"", 5, "note", "not known"},
        Breakage{"\"program\": 1", "\"program\": 0", 8, "programs[0].program", "0 is not between 1 and 8"},
        Breakage{"\"program\": 1", "\"program\": 9", 8, "programs[0].program", "9 is not between 1 and 8"},
        Breakage{"\"program\": 1", "\"program\": \"1\"", 8, "programs[0].program", "whole number"},
        Breakage{"\"shift\": 0", "\"shift\": 26", 9, "programs[0].shift", "26 is not between 0 and 25"},
        Breakage{"\"shift\": 0,", "", 7, "programs[0].shift", "missing"},
        Breakage{"\"cam\": 7", "\"cam\": 8", 12, "programs[0].cams[1].cam", "8 is not between 0 and 7"},
        Breakage{"\"cam\": 7", "\"cam\": -1", 12, "programs[0].cams[1].cam", "not between 0 and 7"},
        Breakage{"\"cam\": 7", "\"cam\": 3", 12, "programs[0].cams[1].cam", "Cam 3 is already given above"},
        Breakage{"531", "8192", 11, "programs[0].cams[0].stop", "8192 is not between 0 and 8191"},
        Breakage{"21", "-1", 11, "programs[0].cams[0].start", "not between 0 and 8191"},
        Breakage{"21", "21.0", 11, "programs[0].cams[0].start", "whole number"},
        Breakage{"true", "1", 11, "programs[0].cams[0].active", "true or false"},
        Breakage{"\"active\": false", "\"active\": false, \"name\": \"x\"", 12, "programs[0].cams[1].name",
                 "not known"},
        Breakage{"    }\n  ]", "    }, 7\n  ]", 14, "programs[1]", "object"},
        Breakage{"    }\n  ]", "    }, {\"program\": 1, \"shift\": 0, \"cams\": []}\n  ]", 14,
                 "programs[1].program", "Cam program 1 is already given above"}));

TEST(CamFile, WithoutAnyProgramIsRefused)
{
    const auto file = camFileFromJson(
        R"({"format": "codewheel-cams", "version": 1, "device": "fraba-ocd-ib", "programs": []})", fileName);
    ASSERT_FALSE(file);
    EXPECT_EQ(refusalText(file.error()).toStdString(),
              "press.json, line 1, programs: At least one cam program is expected here. Nothing was taken "
              "from the file.");
}

TEST(CamFile, WhatIsOfAnotherKindIsToldBeforeItsKeys)
{
    for (const QByteArray &other :
         {QByteArray(R"({"events": [], "format": "codewheel-sequence", "version": 1})"),
          QByteArray(R"({"key": "my-encoder", "name": "K3", "version": 2})"),
          QByteArray(R"({"format": ["codewheel-cams"]})")}) {
        const auto file = camFileFromJson(other, fileName);
        ASSERT_FALSE(file);
        EXPECT_EQ(refusalText(file.error()).toStdString(),
                  "press.json, line 1, format: This is not a file of cam programs: the format is not "
                  "\"codewheel-cams\". Nothing was taken from the file.");
    }
}

TEST(CamFile, WhatIsNoJsonIsToldWithoutAKey)
{
    for (const QByteArray &nonsense :
         {QByteArray("CAM;START"), QByteArray(), QByteArray(100'000, '['), sound + "x", sound.chopped(3)}) {
        const auto file = camFileFromJson(nonsense, fileName);
        ASSERT_FALSE(file);
        EXPECT_TRUE(refusalText(file.error())
                        .contains(QRegularExpression(QStringLiteral(R"(^press\.json, line \d+: \w)"))))
            << refusalText(file.error()).toStdString();
    }
}

TEST(CamFile, IsRefusedWhereTheEncoderHasFewerPositions)
{
    EXPECT_TRUE(camFileFromJson(sound, fileName, 8000));
    const auto file = camFileFromJson(sound, fileName, 7999);
    ASSERT_FALSE(file);
    EXPECT_EQ(std::get<QString>(file.error().arguments[2]).toStdString(), "programs[0].cams[1].start");
}

TEST(CamFile, GivesTheProgramWantedOrNone)
{
    auto file = camFileFromJson(sound, fileName);
    ASSERT_TRUE(file);
    EXPECT_EQ(camProgramOf(*file, 1, fileName), file->programs.front());
    const auto other = camProgramOf(*file, 2, fileName);
    ASSERT_FALSE(other);
    EXPECT_EQ(refusalText(other.error()).toStdString(),
              "press.json contains cam program 1, not 2. Choose program 1, or another file.");
}

TEST(CamFile, SavedInStableOrderSaysTheSameWhenLoaded)
{
    std::mt19937 random(544);
    const auto below = [&](std::uint32_t limit) {
        return std::int64_t{std::uniform_int_distribution<std::uint32_t>(0, limit - 1)(random)};
    };
    for (int round = 0; round < 200; ++round) {
        CamFile file{QStringLiteral("a \"device\" of Österreich"), std::nullopt, {}};
        for (unsigned number = 1; number <= CamProgram::programs; ++number) {
            CamProgram program{.number = number, .cam = {}, .shift = static_cast<unsigned>(below(26))};
            for (Cam &cam : program.cam)
                cam = {below(1 << 25), below(1 << 25), below(2) == 1};
            file.programs.push_back(program);
        }
        const QByteArray json = camFileToJson(file);
        const auto loaded = camFileFromJson(json, fileName);
        ASSERT_TRUE(loaded) << refusalText(loaded.error()).toStdString();
        EXPECT_EQ(*loaded, file);
        std::ranges::shuffle(file.programs, random);
        EXPECT_EQ(camFileToJson(file), json);
    }
}

} // namespace
} // namespace codewheel
