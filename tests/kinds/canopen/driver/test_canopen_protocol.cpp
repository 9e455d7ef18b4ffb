// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct CanopenProtocolTest : ::testing::Test
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &device = *catalog.find(u"canopen-406-multi-turn");
    const Protocol &protocol = protocolOf(device);

    std::string texts(const Job &job) const
    {
        QStringList texts;
        const auto steps = plannedSteps(device, job);
        EXPECT_TRUE(steps);
        for (const Step &step : steps.value_or(std::vector<Step>()))
            texts << protocol.stepText(device, step);
        return texts.join(u'|').toStdString();
    }
    std::optional<PositionScale> scale(const ParameterValues &values) const
    {
        return scaleOf(device, [&](Parameter parameter) { return valueOf(values, parameter); });
    }
};

TEST_F(CanopenProtocolTest, StepsSayWhatTheyDo)
{
    const WriteParameters write{
        .values = {{Parameter::steps, 400}, {Parameter::scaling, 1}, {Parameter::direction, 1}},
        .previous = {}};
    EXPECT_EQ(texts(write), "read 6004h:0|6001h:0, steps := 400|read 6001h:0 back|"
                            "read 6000h:0, of which other bits stay as they are|"
                            "6000h:0, scaling := 1 (on), direction := 1 (CCW)|read 6000h:0 back|"
                            "store what is in force (1010h:1 := \"save\")|"
                            "read 6500h:0, operating parameters|read 6509h:0, offset|read 6004h:0");
    EXPECT_NE(texts(ResetToDefault{}).find("|reset the node|wait until the node reports again|"),
              std::string::npos);
}

TEST_F(CanopenProtocolTest, ValuesAreInTheirSteps)
{
    const WriteParameters write{
        .values = {{Parameter::steps, 4000}, {Parameter::scaling, 1}, {Parameter::direction, 0}},
        .previous = {}};
    ParameterValues found;
    const auto steps = plannedSteps(device, write);
    for (const Step &step : *steps)
        if (takesValue(step))
            for (const ParameterValue &value : protocol.valuesIn(device, step))
                found.push_back(value);
    EXPECT_EQ(found, write.values);
}

TEST_F(CanopenProtocolTest, StoringIsWhatCostsTheEeprom)
{
    const auto cost = [&](const Job &job) { return eepromWritesOf(*plannedSteps(device, job), device); };
    EXPECT_EQ(cost(ReadParameters{{Parameter::steps}}), 0);
    EXPECT_EQ(
        cost(WriteParameters{.values = {{Parameter::steps, 1}, {Parameter::direction, 1}}, .previous = {}}),
        1);
    EXPECT_EQ(cost(SetPreset{.value = 0}), 1);
    EXPECT_EQ(cost(ResetToDefault{}), 1);
    EXPECT_EQ(cost(StoreParameters{}), 1);
    EXPECT_EQ(cost(WriteCams{{CamProgram()}, true, {}}), 1);
}

TEST_F(CanopenProtocolTest, WhatTheEncoderCannotDoIsRefused)
{
    EXPECT_FALSE(plannedSteps(device, SwitchMode{}));
    EXPECT_FALSE(plannedSteps(device, SendWords{{1}}));
    EXPECT_FALSE(plannedSteps(device, EndParameterization{}));
    EXPECT_FALSE(plannedSteps(device, ReadCams{{2}, {}}));
    EXPECT_FALSE(plannedSteps(*catalog.find(u"fraba-ocd-ib"), StoreParameters{}));
}

TEST_F(CanopenProtocolTest, ThePositionIsScaledByResolutionAndRange)
{
    ParameterValues values{{Parameter::steps, 4096},       {Parameter::measuringRange, 16'777'216},
                           {Parameter::scaling, 1},        {Parameter::direction, 1},
                           {Parameter::of(u"6501"), 8192}, {Parameter::of(u"6502"), 4096}};
    ASSERT_TRUE(scale(values));
    EXPECT_EQ(scale(values)->turns, 4096);
    EXPECT_FALSE(scale(values)->clockwise);
    replaceValue(values, {Parameter::measuringRange, 16'777'215}); // the highest position
    EXPECT_EQ(scale(values)->total(), 16'777'216);
    replaceValue(values, {Parameter::scaling, 0});
    EXPECT_EQ(scale(values)->total(), 8192 * 4096);
    replaceValue(values, {Parameter::scaling, 1});
    replaceValue(values, {Parameter::measuringRange, 5000});
    EXPECT_FALSE(scale(values)) << "no whole number of turns";
}

} // namespace
} // namespace codewheel
