// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/value_text.h"

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
    EXPECT_EQ(valueText(*fraba.find(Parameter::temperature), 215), QStringLiteral("21,5"));
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(unitText(Unit::tenthDegreeCelsius), QStringLiteral("°C"));
    EXPECT_EQ(unitText(Unit::none), QString());
}

TEST(ValueText, ARegisterIsHexadecimalInAnyLocale)
{
    const Catalog catalog = Catalog::builtIn();
    const ParameterDescription &first = *catalog.find(u"fraba-ocd-ib")->find(opcRegister(0));
    EXPECT_EQ(valueText(first, 0x0237), QStringLiteral("0237h"));
    EXPECT_EQ(valueText(first, 0xFFFF), QStringLiteral("FFFFh"));
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
