// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions that slipped past the catalog: what they lack is refused, and nothing is sent instead.
#include "catalog/catalog.h"
#include "jobs/protocol.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

class IncompleteDescription : public testing::Test
{
protected:
    DeviceDescription without(QStringView key, Parameter parameter)
    {
        DeviceDescription device = *catalog.find(key);
        std::erase_if(device.parameters,
                      [&](const ParameterDescription &one) { return one.parameter == parameter; });
        return device;
    }
    static ParameterDescription &row(DeviceDescription &device, Parameter parameter)
    {
        return *std::ranges::find(device.parameters, parameter, &ParameterDescription::parameter);
    }
    static std::optional<RefusalCode> refusalOf(const DeviceDescription &device, const Job &job)
    {
        const auto steps =
            plannedSteps(device, job, {.known = {{Parameter::startUpMode, 1, Evidence::told, {}}}});
        return steps ? std::nullopt : std::optional(steps.error().id);
    }

    const Catalog catalog = Catalog::builtIn();
};

TEST_F(IncompleteDescription, NoK3IsSetWhosePresetHasNoWord)
{
    for (const QStringView key : {u"fraba-ocd-ib", u"baumer-gxp6w", u"generic-k3"}) {
        DeviceDescription device = without(key, Parameter::preset);
        EXPECT_EQ(refusalOf(device, SetPreset{}), RefusalId::presetNotSupported);
        EXPECT_EQ(refusalOf(device, SetPreset{.value = 1000}), RefusalId::presetNotSupported);
        device = *catalog.find(key);
        row(device, Parameter::preset).canBeWritten = false;
        EXPECT_EQ(refusalOf(device, SetPreset{}), RefusalId::presetNotSupported);
        EXPECT_EQ(refusalOf(device, SetPreset{.value = 1000}), RefusalId::presetNotSupported);
    }
}

// A FRABA activates a programmed preset once: the old value is programmed again, so it must be read.
TEST_F(IncompleteDescription, APresetThatCannotBeReadIsGiven)
{
    DeviceDescription fraba = *catalog.find(u"fraba-ocd-ib");
    row(fraba, Parameter::preset).canBeRead = false;
    EXPECT_EQ(refusalOf(fraba, SetPreset{}), RefusalId::presetNeedsValue);
    EXPECT_EQ(refusalOf(fraba, SetPreset{.value = 1000}), std::nullopt);
    EXPECT_EQ(refusalOf(fraba, SetPreset{.value = {}, .command = PresetCommand::manufacturer}), std::nullopt)
        << "it activates what is programmed";
}

TEST_F(IncompleteDescription, NoPositionIsSetWhereTheDescriptionSaysThatItCannotBe)
{
    for (const QStringView key : {u"fraba-ocd-ib", u"tr-la66", u"kuebler-esc-rs485"}) {
        DeviceDescription device = *catalog.find(key);
        EXPECT_EQ(refusalOf(device, SetPreset{.value = 1000}), std::nullopt);
        device.capabilities.presets = false;
        EXPECT_EQ(refusalOf(device, SetPreset{.value = 1000}), RefusalId::presetNotSupported);
    }
    EXPECT_EQ(refusalOf(without(u"kuebler-esc-rs485", Parameter::preset), SetPreset{.value = 1000}),
              RefusalId::presetNotSupported)
        << "the range of the position is not known";
}

TEST_F(IncompleteDescription, NoCamProgramIsSentThatTheEncoderLacks)
{
    DeviceDescription device = *catalog.find(u"fraba-ocd-ib");
    device.capabilities.cams->programs = 2;
    EXPECT_EQ(refusalOf(device, ReadCams{.programs = {1, 2}, .afterwards = {}}), std::nullopt);
    for (const Job &job : {Job{ReadCams{.programs = {1, 3}, .afterwards = {}}}, Job{SwitchMode{Mode::cam, 3}},
                           Job{WriteCams{.programs = {{.number = 3}}, .afterwards = {}}}})
        EXPECT_EQ(refusalOf(device, job), RefusalId::camProgramOutOfRange);
}

} // namespace
} // namespace codewheel
