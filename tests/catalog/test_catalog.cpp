// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "tests/support/breakage.h"

#include <QFile>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// A complete description; each test breaks one place of it.
const QByteArray sound = R"({
  "key": "some-k3",
  "vendor": "Some",
  "name": "K3",
  "manual": "a manual",
  "profile": "K3",
  "dialect": "fraba",
  "idCode": "37h",
  "deviceCode": "0237h",
  "inWords": 2,
  "outWords": 2,
  "physicalStepsPerTurn": 4096,
  "physicalTurns": 1,
  "parameters": [
    {"parameter": "steps", "number": 1, "readOut": 1, "minimum": 1, "maximum": 4096, "factory": 4096},
    {"parameter": "direction", "number": 3, "minimum": 3, "maximum": 4,
     "choices": [{"value": 3, "key": "cw"}, {"value": 4, "key": "ccw"}]},
    {"parameter": "temperature", "readOut": 12, "minimum": -500, "maximum": 1500, "unit": "tenth-degree-celsius"},
    {"parameter": "preset", "number": 4, "readOut": 4, "minimum": 0, "maximum": 4095},
    {"parameter": "multi-turn-steps-minus-1", "readOut": 10, "minimum": 0, "maximum": 3}
  ],
  "errors": [
    {"number": 1, "meaning": "wrongParameterData"},
    {"number": 14, "meaning": "batteryLow", "warning": true}
  ],
  "capabilities": {
    "presets": true, "cams": false, "readingHidesPosition": true, "presetIsStored": true, "hasBattery": false,
    "eepromBudget": 200, "eepromLimit": 500, "resets": true
  },
  "quirks": {
    "confirmsWhileProcessing": true, "presetNeedsRearming": true, "mayCountStepsMinusOne": true, "hasModes": true
  }
}
)";

class BrokenDescription : public testing::TestWithParam<Breakage>
{};

TEST_P(BrokenDescription, IsRefusedWithLineKeyAndReason)
{
    Catalog catalog;
    const auto added = catalog.add(brokenBy(GetParam(), sound), QStringLiteral("some.json"));
    ASSERT_FALSE(added);
    EXPECT_TRUE(catalog.devices().empty());
    expectNamed(GetParam(), added.error(), QStringLiteral("some.json"));
}

constexpr Breakage breakages[] = {
    // the file as a whole
    {R"("inWords": 2,)", R"("inWords": 2)", 11, "",
     "not valid JSON: check brackets, commas and quotation marks."},
    {R"("inWords": 2,)", R"("outWords": 2,)", 11, "outWords", "is here twice"},
    {"  }\n}\n", "  }\n}\n{}", 34, "", "not valid JSON"},
    {"  }\n}\n", "  }\n", 33, "", "not valid JSON"},
    {R"("a manual")", R"('a manual')", 5, "", "not valid JSON"},
    {R"("a manual")", "\"Drehgeber \xFC\"", 5, "", "not UTF-8 text: save the file as UTF-8"}, // Latin-1
    {R"("a manual")", R"([[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]])", 1, "", "nested too deeply"},
    // types
    {R"("Some")", "7", 3, "vendor", "text"},
    {R"("Some")", R"(" ")", 3, "vendor", "text"},
    {R"("inWords": 2)", R"("inWords": "2")", 10, "inWords", "whole number"},
    {R"("inWords": 2)", R"("inWords": 2.0)", 10, "inWords", "whole number"},
    {R"("inWords": 2)", R"("inWords": 18446744073709551615)", 10, "inWords", "whole number"},
    {R"("inWords": 2)", R"("inWords": -1)", 10, "inWords", "-1 is not between 0 and 32"},
    {R"("presets": true)", R"("presets": 1)", 27, "capabilities.presets", "true or false"},
    {R"("profile": "K3")", R"("notes": {"de": "Text"}, "profile": "K3")", 6, "notes.en", "missing"},
    {R"("profile": "K3")", R"("notes": {"en": "Text", "fr": "Texte"}, "profile": "K3")", 6, "notes.fr",
     "not known"},
    {R"("idCode": "37h")", R"("idCode": 55)", 8, "idCode", "text"},
    {R"("idCode": "37h")", R"("idCode": "37")", 8, "idCode", "37h"},
    {R"("quirks": {)", R"("quirks": [], "q": {)", 30, "q", "not known"},
    {R"({"number": 1, "meaning": "wrongParameterData"})", "1", 23, "errors[0]", "object"},
    // keys
    {R"("name": "K3",)", "", 1, "name", "missing"},
    {R"("name":)", R"("nmae":)", 4, "nmae", "not known. Known are: key, vendor, name"},
    {R"("readOut": 1, )", R"("readout": 1, )", 15, "parameters[0].readout", "not known"},
    {R"("minimum": 1, )", "", 15, "parameters[0].minimum", "missing"},
    {R"(, "hasModes": true)", "", 30, "quirks.hasModes", "missing"},
    // names
    {R"("some-k3")", R"("Some K3")", 2, "key", "letters a to z"},
    {R"("profile": "K3")", R"("profile": "K9")", 6, "profile",
     "\"K9\" is not known here. Known are: K1, K2, K3"},
    {R"("dialect": "fraba")", R"("dialect": "FRABA")", 7, "dialect", "not known"},
    {R"("vendor": "Some",)", "", 1, "vendor", "generic dialect"},
    {R"("parameter": "steps")", R"("parameter": "step")", 15, "parameters[0].parameter",
     "steps, revolutions"},
    {R"("tenth-degree-celsius")", R"("kelvin")", 18, "parameters[2].unit", "kelvin"},
    {R"("batteryLow")", R"("cancelled")", 24, "errors[1].meaning", "cancelled"},
    // The data field of a K3 has 25 bits; only what is written must fit.
    {R"("maximum": 4096)", R"("maximum": 33554432)", 15, "parameters[0].maximum", "between 0 and 33554431"},
    {R"("maximum": 4096)", R"("maximum": 1099511627776)", 15, "parameters[0].maximum", "no room"},
    {R"("minimum": 1, )", R"("minimum": -1, )", 15, "parameters[0].minimum", "between 0 and 33554431"},
    {R"("minimum": 1, )", R"("minimum": 1, "text": 8, )", 15, "parameters[0].text", "has only numbers"},
    // rules
    {R"("deviceCode": "0237h")", R"("deviceCode": "0236h")", 9, "deviceCode", "idCode"},
    {R"("physicalTurns": 1)", R"("coding": "gray", "physicalTurns": 1)", 13, "coding", "Only a K1 and a K2"},
    {R"("physicalTurns": 1)", R"("coding": "Gray", "physicalTurns": 1)", 13, "coding",
     "Known are: binary, signed, gray"},
    {R"("factory": 4096)", R"("factory": 0)", 15, "parameters[0].factory", "not between"},
    {R"("parameter": "temperature")", R"("parameter": "steps")", 18, "parameters[2].parameter", "twice"},
    {R"("number": 3)", R"("number": 16)", 16, "parameters[1].number", "between 1 and 15"},
    {R"("number": 3, )", "", 16, "parameters[1].number", "needs a number"},
    {R"("ccw")", R"("cw")", 17, "parameters[1].choices[1].key", "twice"},
    // overlapping ranges: minimum and maximum, choices and their range, budget and limit
    {R"("minimum": 1, )", R"("minimum": 5000, )", 15, "parameters[0].minimum", "larger than the maximum"},
    {R"("value": 4)", R"("value": 5)", 17, "parameters[1].choices[1].value", "between 3 and 4"},
    {R"("eepromBudget": 200)", R"("eepromBudget": 501)", 28, "capabilities.eepromBudget", "eepromLimit"},
    // overlapping ranges: numbers, read-out codes, values, errors, the number of the reset
    {R"("number": 3)", R"("number": 1)", 16, "parameters[1].number", "twice"},
    {R"("number": 3)", R"("number": 7)", 16, "parameters[1].number", "number 7"},
    {R"("readOut": 12)", R"("readOut": 1)", 18, "parameters[2].readOut", "twice"},
    {R"("value": 4)", R"("value": 3)", 17, "parameters[1].choices[1].value", "twice"},
    {R"("number": 14)", R"("number": 1)", 24, "errors[1].number", "twice"},
};

INSTANTIATE_TEST_SUITE_P(Catalog, BrokenDescription, testing::ValuesIn(breakages));

TEST(Catalog, TakesASoundDescription)
{
    Catalog catalog;
    ASSERT_TRUE(catalog.add(sound, QStringLiteral("some.json")));
    const DeviceDescription *device = catalog.find(u"some-k3");
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(device->fullName(), QStringLiteral("Some K3"));
    EXPECT_EQ(device->find(Parameter::temperature)->unit, Unit::tenthDegreeCelsius);
    EXPECT_EQ(device->find(Parameter::temperature)->minimum, -500);
    EXPECT_TRUE(device->find(Parameter::steps)->stored);
    EXPECT_FALSE(device->find(Parameter::temperature)->stored);
    EXPECT_TRUE(device->capabilities.reads);
    EXPECT_FALSE(device->capabilities.serialNumber);
    EXPECT_EQ(catalog.generic(0x0237), nullptr);
}

TEST(Catalog, RefusesASecondDeviceOfTheSameKey)
{
    Catalog catalog;
    ASSERT_TRUE(catalog.add(sound, QStringLiteral("some.json")));
    const auto added = catalog.add(sound, QStringLiteral("again.json"));
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().file, QStringLiteral("again.json"));
    EXPECT_EQ(added.error().line, 2);
    EXPECT_TRUE(added.error().reason.contains(QStringLiteral("some-k3")));
    EXPECT_EQ(catalog.devices().size(), 1u);
}

TEST(Catalog, RefusesWhatIsNoDescriptionAtAll)
{
    for (const char *text :
         {"", " ", "null", "7", "[]", "\"text\"", "{}", "\xFF\xFE", "{\"key\": null}", "[{}]"}) {
        Catalog catalog;
        const auto added = catalog.add(text, QStringLiteral("some.json"));
        ASSERT_FALSE(added) << text;
        EXPECT_FALSE(added.error().reason.isEmpty()) << text;
        EXPECT_GE(added.error().line, 1) << text;
    }
}

TEST(Catalog, SaysThatAFileIsEmpty)
{
    for (const char *text : {"", " ", "\n\n"}) {
        const auto added = Catalog().add(text, QStringLiteral("some.json"));
        ASSERT_FALSE(added);
        EXPECT_EQ(added.error().reason, QStringLiteral("The file is empty."));
    }
}

// However a file is truncated or overwritten: a fault or a description, never a crash.
TEST(Catalog, SurvivesAnyTruncationAndAnyOverwrittenByte)
{
    for (qsizetype size = 0; size < sound.size() - 2; ++size)
        EXPECT_FALSE(Catalog().add(sound.first(size), QString())) << size;
    for (qsizetype i = 0; i < sound.size(); ++i)
        for (const char c : {'\0', '"', '{', ']', ',', '9', '\xC3'}) {
            QByteArray json = sound;
            json[i] = c;
            const auto added = Catalog().add(json, QString());
            EXPECT_TRUE(added || !added.error().reason.isEmpty()) << i;
        }
}

} // namespace
} // namespace codewheel
