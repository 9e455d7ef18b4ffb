// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// One parameter of its own.
QByteArray nodeWith(const char *key, const char *name)
{
    return QByteArray(
               R"({"key": "KEY", "vendor": "Rotor Works", "name": "KEY", "manual": "M", "profile": "CiA-406",
        "physicalStepsPerTurn": 0, "physicalTurns": 0, "parameters": [
        {"parameter": "2f31", "name": "NAME", "object": "2f31", "type": "u8", "minimum": 0, "maximum": 255}],
        "errors": [], "capabilities": {"presets": false, "cams": false, "readingHidesPosition": false,
        "presetIsStored": false, "hasBattery": false}, "quirks": {"confirmsWhileProcessing": false,
        "presetNeedsRearming": false, "mayCountStepsMinusOne": false, "hasModes": false}})")
        .replace("KEY", key)
        .replace("NAME", name);
}

TEST(NamesOfParameters, AreThoseOfTheDescriptionThatHasThem)
{
    Catalog catalog;
    const auto added = catalog.add(nodeWith("one", "Filter"), QStringLiteral("one.json"));
    ASSERT_TRUE(added) << added.error().reason.toStdString();
    ASSERT_TRUE(catalog.add(nodeWith("two", "Damping"), QStringLiteral("two.json")));
    const Parameter own = *parameterFromKey(u"2f31");
    EXPECT_EQ(parameterName(own), QStringLiteral("2f31")) << "nobody knows which";
    EXPECT_EQ(parameterName(catalog.find(QStringLiteral("one")), own), QStringLiteral("Filter"));
    EXPECT_EQ(parameterName(catalog.find(QStringLiteral("two")), own), QStringLiteral("Damping"));
    EXPECT_EQ(parameterName(catalog.find(QStringLiteral("two"))->parameters.front()),
              QStringLiteral("Damping"));
    EXPECT_EQ(parameterNameInText(*catalog.find(QStringLiteral("one")), own), QStringLiteral("Filter"));
    EXPECT_EQ(parameterNameInText(*catalog.find(QStringLiteral("one")), Parameter::preset),
              parameterNameInText(Parameter::preset));
    EXPECT_EQ(parameterName(nullptr, own), QStringLiteral("2f31"));
}

TEST(NamesOfParameters, ThatEverybodyKnowsAreTheSameEverywhere)
{
    const Catalog catalog = Catalog::builtIn();
    for (const DeviceDescription &device : catalog.devices())
        EXPECT_EQ(parameterName(&device, Parameter::preset), parameterName(Parameter::preset));
}

} // namespace
} // namespace codewheel
