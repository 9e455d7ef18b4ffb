// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/interbus/make_driver.h"
#include "tests/kinds/esc/driver/esc_bench.h"
#include "vocabulary/hex.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const DeviceDescription &kuebler()
{
    static const Catalog catalog = Catalog::builtIn();
    return *catalog.find(u"kuebler-esc-rs422");
}

WriteParameters writing(ParameterValues values)
{
    return {.values = std::move(values), .previous = {}};
}

TEST(EscRefusals, WhatTheEncoderCannotDo)
{
    EscBench bench;
    const std::pair<Job, RefusalCode> rows[] = {
        {SendWords{{0x1234}}, RefusalId::sendingNotSupported},
        {ReadCams{}, RefusalId::camsNotSupported},
        {WriteCams{}, RefusalId::camsNotSupported},
        {ResetToDefault{}, RefusalId::resetNotSupported},
        {SwitchMode{.mode = Mode::velocity}, RefusalId::velocityNotSupported},
        {SwitchMode{.mode = Mode::cam, .camProgram = 1}, RefusalId::camsNotSupported},
        {EndParameterization{}, RefusalId::jobNotSupported},
        {ReadParameters{}, RefusalId::nothingToDo},
        {ReadParameters{{Parameter::temperature}}, RefusalId::parameterNotSupported},
        {ReadParameters{{Parameter::lineAddress}}, RefusalId::parameterNotSupported},
        {writing({}), RefusalId::nothingToDo},
        {writing({{Parameter::preset, 5}}), RefusalId::parameterReadOnly},
        {writing({{Parameter::steps, 5}, {Parameter::steps, 6}}), RefusalId::parameterGivenTwice},
        {WriteParameters{.values = {{Parameter::steps, 5}}, .previous = {}, .initialisePreset = true},
         RefusalId::presetNeedsValue},
        {SetPreset{}, RefusalId::presetNeedsValue},
        {SetPreset{.value = 5, .command = PresetCommand::manufacturer},
         RefusalId::manufacturerPresetNotSupported},
    };
    for (const auto &[job, id] : rows) {
        const auto begun = bench.begin(job);
        ASSERT_FALSE(begun) << job.index();
        EXPECT_EQ(begun.error().id, id) << job.index();
    }
    EXPECT_FALSE(bench.driver.busy());
}

// Manual, "Programmable parameters"
TEST(EscRefusals, ValuesBeyondTheRangesOfTheManual)
{
    EscBench bench;
    const std::tuple<Parameter, std::int64_t, std::int64_t> rows[] = {
        {Parameter::steps, 1, 8192},
        {Parameter::revolutions, 1, 4096},
        {Parameter::lowerLimit, 1, 33'554'431},
        {Parameter::upperLimit, 1, 33'554'431},
        {Parameter::lineAddress, 1, 31},
    };
    for (const auto &[parameter, least, most] : rows)
        for (const std::int64_t value : {least - 1, most + 1}) {
            const auto begun = bench.begin(writing({{parameter, value}}));
            ASSERT_FALSE(begun) << value;
            EXPECT_EQ(begun.error(), (Refusal{RefusalKind::badInput,
                                              RefusalId::valueOutOfRange,
                                              {parameter, value, least, most}}));
        }
    for (const std::int64_t value : {0, 335, 33'554'432})
        EXPECT_EQ(bench.begin(writing({{Parameter::measuringRange, value}})).error().id,
                  RefusalId::valueOutOfRange);
    for (const std::int64_t value : {std::int64_t{0}, std::int64_t{33'554'432}})
        EXPECT_EQ(bench.begin(SetPreset{.value = value}).error().id, RefusalId::valueOutOfRange);
}

// Manual, read command F: 0.00001 to 1.0.
TEST(EscRefusals, AScalingFactorThatCannotBe)
{
    EscBench bench;
    for (const std::int64_t value :
         {std::int64_t{0x7FFFFFFF}, std::int64_t{0x20000001}, std::int64_t{0x14F8}, std::int64_t{1}}) {
        const auto begun = bench.begin(writing({{Parameter::scalingFactor, value}}));
        ASSERT_FALSE(begun) << value;
        const QString shown = hexWord(static_cast<Word>(value)) + u'h';
        EXPECT_EQ(begun.error(), (Refusal{RefusalKind::badInput,
                                          RefusalId::valueOutOfRange,
                                          {Parameter::scalingFactor, shown, QStringLiteral("000014F9h"),
                                           QStringLiteral("20000000h")}}))
            << "as it can be typed";
    }
    for (const std::int64_t value : {0x14F9, 0x20000000}) {
        EscBench other;
        EXPECT_TRUE(other.begin(writing({{Parameter::scalingFactor, value}}))) << value;
    }
    EscBench finer({.fractionBits = 30});
    EXPECT_TRUE(finer.begin(writing({{Parameter::scalingFactor, 0x40000000}})));
}

TEST(EscRefusals, TheRangesAreThoseTheEncoderTells)
{
    EscBench bench;
    bench.has["M"] = "00001000";
    bench.has["U"] = "0010";
    bench.settle();
    EXPECT_TRUE(
        bench.finish(ReadParameters{{Parameter::measuringRange, Parameter::revolutions, Parameter::scaling}})
            .result);
    EXPECT_EQ(bench.begin(SetPreset{.value = 4097}).error(),
              (Refusal{RefusalKind::badInput,
                       RefusalId::valueOutOfRange,
                       {Parameter::preset, std::int64_t{4097}, std::int64_t{1}, std::int64_t{4096}}}));
    EXPECT_EQ(bench.begin(writing({{Parameter::upperLimit, 4097}})).error().id, RefusalId::valueOutOfRange);
    EXPECT_EQ(bench.begin(writing({{Parameter::measuringRange, 16 * 8192 + 1}})).error().id,
              RefusalId::valueOutOfRange);
    // The values of the same job count.
    EXPECT_TRUE(bench.begin(writing({{Parameter::measuringRange, 9000}, {Parameter::upperLimit, 9000}})));
}

TEST(EscValues, NarrowedOnlyByWhatIsKnown)
{
    const auto range = [](Parameter parameter, const ParameterValues &known) {
        const ParameterDescription narrowed = escNarrowed(kuebler(), parameter, known);
        return std::pair(narrowed.minimum, narrowed.maximum);
    };
    using Range = std::pair<std::int64_t, std::int64_t>;
    EXPECT_EQ(range(Parameter::preset, {}), Range(1, 33'554'431));
    EXPECT_EQ(range(Parameter::preset, {{Parameter::measuringRange, 33'554'432}}), Range(1, 33'554'431));
    const ParameterValue on{Parameter::scaling, 1};
    const ParameterValue off{Parameter::scaling, 0};
    EXPECT_EQ(range(Parameter::lowerLimit, {on, {Parameter::measuringRange, 500}}), Range(1, 500));
    EXPECT_EQ(range(Parameter::upperLimit, {off, {Parameter::measuringRange, 500}}), Range(1, 33'554'431))
        << "the position is in physical steps";
    EXPECT_EQ(range(Parameter::lowerLimit, {on, {Parameter::measuringRange, 0}}), Range(1, 33'554'431))
        << "an encoder that tells nonsense leaves the range of the manual";
    // 0.00001 to 1.0 of the physical steps
    EXPECT_EQ(range(Parameter::measuringRange, {}), Range(336, 33'554'431));
    EXPECT_EQ(range(Parameter::measuringRange, {{Parameter::revolutions, 2}}), Range(1, 16384));
}

// Manual: "address will be set to 21", range "01..31"
TEST(EscValues, BothReadingsOfAnAddress)
{
    using Readings = std::vector<EscLineAddress>;
    EXPECT_EQ(escReadingsOf({9}), (Readings{{9}}));
    EXPECT_EQ(escReadingsOf({0x10}), (Readings{{0x10}, {10}}));
    EXPECT_EQ(escReadingsOf({0x15}), (Readings{{0x15}, {15}}));
    EXPECT_EQ(escReadingsOf({0x1A}), (Readings{{0x1A}}));
    EXPECT_EQ(escReadingsOf({0x19}), (Readings{{0x19}, {19}}));
}

TEST(EscSteps, ArePlannedForReviewAndCounted)
{
    const std::vector<Known> known{{Parameter::lineAddress, 0x12, Evidence::read, {}}};
    const auto steps = plannedSteps(kuebler(), writing({{Parameter::steps, 864}, {Parameter::direction, 1}}),
                                    {.known = known});
    ASSERT_TRUE(steps);
    EXPECT_EQ(eepromWritesOf(*steps, kuebler()), 3) << "GR, GF, GD";
    std::vector<std::string> writes;
    for (const Step &step : *steps)
        if (writesValue(step))
            writes.push_back(step.line.toStdString());
    EXPECT_EQ(writes, (std::vector<std::string>{"12GR00000360", "12GF03600000", "12GD1"}));
    const auto preset = plannedSteps(kuebler(), SetPreset{.value = 0x5200});
    ASSERT_TRUE(preset);
    EXPECT_EQ(eepromWritesOf(*preset, kuebler()), 1);
    EXPECT_FALSE(plannedSteps(kuebler(), SetPreset{}));
}

TEST(EscSteps, ADriverIsMadeForTheLineAndNotForTheBus)
{
    const Catalog catalog = Catalog::builtIn();
    EXPECT_EQ(makeDriver(kuebler()), nullptr);
    ASSERT_NE(makeRequestDriver(kuebler(), {4}), nullptr);
    EXPECT_EQ(makeRequestDriver(kuebler(), {4})->address(), EscLineAddress{4});
    EXPECT_EQ(makeRequestDriver(*catalog.find(u"tr-la66"), {4}), nullptr);
}

} // namespace
} // namespace codewheel
