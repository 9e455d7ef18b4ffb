// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/value_text.h"
#include "kinds/esc/protocol/esc_forms.h"

#include <QLocale>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(ValueText, ValuesWithANameShowBoth)
{
    const Catalog catalog = Catalog::builtIn();
    const ParameterDescription &coding = *catalog.find(u"baumer-gxp6w")->find(Parameter::coding);
    EXPECT_EQ(choiceName(coding, 3), QStringLiteral("unsigned, CW"));
    EXPECT_EQ(valueText(coding, 6), QStringLiteral("6 (Gray, CCW)"));
    EXPECT_EQ(choiceName(coding, 7), QString());
    EXPECT_EQ(valueText(coding, 7), QStringLiteral("7"));
}

TEST(ValueText, NumbersAreWrittenByLocale)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = *catalog.find(u"fraba-ocd-ib");
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(valueText(*fraba.find(Parameter::steps), 33'554'431), QStringLiteral("33.554.431"));
    EXPECT_EQ(valueText(*fraba.find(Parameter::serialNumber), 20'417), QStringLiteral("20417 (4FC1h)"))
        << "as on the label";
    EXPECT_EQ(valueText(*fraba.find(Parameter::temperature), 215), QStringLiteral("21,5"));
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(unitText(Unit::tenthDegreeCelsius), QStringLiteral("°C"));
    EXPECT_EQ(unitText(Unit::none), QString());
}

TEST(ValueText, ARegisterIsHexadecimalInAnyLocale)
{
    const Catalog catalog = Catalog::builtIn();
    const ParameterDescription &first =
        *catalog.find(u"fraba-ocd-ib")->find(Parameter::of(u"opc-register-0"));
    EXPECT_EQ(valueText(first, 0x0237), QStringLiteral("0237h"));
    EXPECT_EQ(valueText(first, 0xFFFF), QStringLiteral("FFFFh"));
}

TEST(ValueText, WhatASerialEncoderTellsIsHexadecimalAndBitByBit)
{
    const Catalog catalog = Catalog::builtIn();
    const auto text = [&catalog](Parameter parameter, std::int64_t value) {
        return valueText(*catalog.find(u"kuebler-esc-rs485")->find(parameter), value);
    };
    EXPECT_EQ(text(Parameter::warnings, 0x8000), QStringLiteral("8000h (standstill)"));
    EXPECT_EQ(text(Parameter::alarms, 0x5000), QStringLiteral("5000h (battery flat, general fault)"));
    EXPECT_EQ(text(Parameter::alarms, 0), QStringLiteral("0000h (none)"));
    EXPECT_EQ(text(Parameter::operatingParameters, 0x7005),
              QStringLiteral("7005h (limit switch active, resolution per revolution, calculated factor, "
                             "scaling on, direction CCW)"));
    EXPECT_EQ(text(Parameter::deviceCode, 0x8000), QStringLiteral("8000h"));
    EXPECT_EQ(text(Parameter::serialNumber, 0x12D5A4), QStringLiteral("1234340 (12D5A4h)"));
    EXPECT_EQ(text(Parameter::lineAddress, 0x12), QStringLiteral("12h (18)"));
    EXPECT_EQ(text(Parameter::direction, 1), QStringLiteral("1 (CCW)")) << "a bit of an answer";
    EXPECT_EQ(text(Parameter::measuringRange, 4096), QStringLiteral("4096")) << "a number";
}

TEST(ValueText, AScalingFactorIsAFractionWhereItsFormatIsKnown)
{
    const Catalog catalog = Catalog::builtIn();
    const ParameterDescription &factor = *catalog.find(u"kuebler-esc-rs485")->find(Parameter::scalingFactor);
    EXPECT_EQ(valueText(factor, 0x1F40'0000), QStringLiteral("1F400000h"));
    EXPECT_EQ(valueText(factor, 0x1F40'0000, KindData(EscValueOptions{.fractionBits = 29})),
              QStringLiteral("1F400000h (0.9765625)"));
    EXPECT_EQ(valueText(factor, 0x1F40'0000, KindData(EscValueOptions{.fractionBits = 30})),
              QStringLiteral("1F400000h (0.48828125)"));
}

TEST(ValueText, SwappedWarningsAreToldAsTheyWereSentToo)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &device = *catalog.find(u"kuebler-esc-rs485");
    const KindData swapped(EscValueOptions{.swapsWarningBytes = true});
    EXPECT_EQ(valueText(*device.find(Parameter::warnings), 0x9800, swapped),
              QStringLiteral("0098h, bytes swapped 9800h (standstill, lower limit switch on, turning CCW)"));
    EXPECT_EQ(valueText(*device.find(Parameter::alarms), 0x4000, swapped),
              QStringLiteral("4000h (battery flat)"));
}

TEST(ValueText, EveryChoiceOfABuiltInDeviceHasAName)
{
    const Catalog catalog = Catalog::builtIn();
    for (const DeviceDescription &device : catalog.devices())
        for (const ParameterDescription &parameter : device.parameters)
            for (const Choice &choice : parameter.choices)
                EXPECT_NE(choiceName(parameter, choice.value), QString()) << choice.key.toStdString();
}

TEST(ValueText, AChoiceWithoutANameShowsItsKey)
{
    ParameterDescription parameter;
    parameter.choices = {{1, QStringLiteral("own")}};
    EXPECT_EQ(valueText(parameter, 1), QStringLiteral("1 (own)"));
}

} // namespace
} // namespace codewheel
