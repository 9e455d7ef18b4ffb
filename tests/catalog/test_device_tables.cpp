// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "tests/support/breakage.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QByteArray soundTables = R"({
  "key": "some-k1",
  "vendor": "Some",
  "name": "K1",
  "manual": "a manual",
  "profile": "K1",
  "idCode": "36h",
  "deviceCode": "0136h",
  "inWords": 1,
  "outWords": 0,
  "physicalStepsPerTurn": 4096,
  "physicalTurns": 1,
  "parameters": [],
  "errors": [],
  "capabilities": {
    "presets": false, "cams": false, "readingHidesPosition": false, "presetIsStored": false, "hasBattery": false
  },
  "quirks": {
    "confirmsWhileProcessing": false, "presetNeedsRearming": false, "mayCountStepsMinusOne": false, "hasModes": false
  },
  "connectors": [
    {"name": {"en": "In", "de": "An"}, "chapter": "3.1", "pins": [
      {"pin": "1", "signal": "DO"},
      {"pin": "2", "signal": "DI", "remark": "a remark"}
    ]}
  ],
  "leds": {
    "chapter": "3.3",
    "lamps": [
      {"name": "UL", "colour": "green", "meaning": "Power"},
      {"name": "BA", "colour": "green", "meaning": "Bus"}
    ],
    "states": [
      {"on": ["UL"], "meaning": "Waiting"},
      {"on": ["UL"], "blinking": ["BA"], "meaning": "Found"}
    ]
  },
  "supply": {"value": "24 V DC", "chapter": "6.1"},
  "limits": [
    {"name": "Data", "chapter": "6", "rows": [
      {"name": "Weight", "value": "500 g"},
      {"name": "Speed", "value": "12 rpm"}
    ]}
  ],
  "orderingKey": {
    "chapter": "8",
    "example": "AB-10 7.x",
    "parts": [
      {"name": "Model", "codes": [{"code": "AB", "meaning": "this"}]},
      {"name": "Turns", "codes": [
        {"code": "10", "meaning": "ten", "turns": 10},
        {"code": "22", "meaning": "two"}
      ]},
      {"name": "Steps", "codes": [{"code": "7", "meaning": "seven", "stepsPerTurn": 7}]},
      {"name": "Any", "any": 1, "optional": true}
    ]
  }
}
)";

class BrokenTables : public testing::TestWithParam<Breakage>
{};

TEST_P(BrokenTables, AreRefusedWithLineKeyAndReason)
{
    Catalog catalog;
    const auto added = catalog.add(brokenBy(GetParam(), soundTables), QStringLiteral("some.json"));
    ASSERT_FALSE(added);
    EXPECT_TRUE(catalog.devices().empty());
    expectNamed(GetParam(), added.error(), QStringLiteral("some.json"));
}

constexpr Breakage tableBreakages[] = {
    // texts
    {R"({"en": "In", "de": "An"})", "7", 22, "connectors[0].name", "{\"en\""},
    {R"({"en": "In", "de": "An"})", R"({"de": "An"})", 22, "connectors[0].name.en", "missing"},
    {R"({"en": "In", "de": "An"})", R"({"en": "In", "fr": "A"})", 22, "connectors[0].name.fr", "not known"},
    {R"("a remark")", R"("")", 24, "connectors[0].pins[1].remark", "text"},
    // connectors
    {R"("pin": "2")", R"("pin": "1")", 24, "connectors[0].pins[1].pin", "twice"},
    {R"("pin": "2")", R"("pin": 2)", 24, "connectors[0].pins[1].pin", "text"},
    {R"("signal": "DO")", R"("sign": "DO")", 23, "connectors[0].pins[0].sign", "not known"},
    // LEDs
    {R"("name": "BA")", R"("name": "UL")", 31, "leds.lamps[1].name", "twice"},
    {R"("on": ["UL"], "meaning": "Waiting")", R"("on": ["XY"], "meaning": "Waiting")", 34,
     "leds.states[0].on", "Known are: UL, BA"},
    {R"("on": ["UL"], "meaning": "Waiting")", R"("on": "UL", "meaning": "Waiting")", 34, "leds.states[0].on",
     "list of texts"},
    {R"("blinking": ["BA"])", R"("blinking": ["UL"])", 35, "leds.states[1].blinking", "on and blink"},
    {R"(, "blinking": ["BA"])", "", 35, "leds.states[1].on", "twice"},
    // supply, limits
    {R"({"value": "24 V DC", "chapter": "6.1"})", R"("24 V")", 38, "supply", "object"},
    {R"("name": "Speed")", R"("name": "Weight")", 42, "limits[0].rows[1].name", "twice"},
    {R"("value": "500 g")", R"("value": 500)", 41, "limits[0].rows[0].value", "text"},
    // ordering key
    {R"("code": "22")", R"("code": "10")", 52, "orderingKey.parts[1].codes[1].code", "twice"},
    {R"("code": "22")", R"("code": "1")", 52, "orderingKey.parts[1].codes[1].code", "cannot be told apart"},
    {R"("code": "22")", R"("code": "101")", 52, "orderingKey.parts[1].codes[1].code", "cannot be told apart"},
    {R"("code": "22")", R"("code": "2-2")", 52, "orderingKey.parts[1].codes[1].code", "letters A to Z"},
    {R"("turns": 10)", R"("turns": 0)", 51, "orderingKey.parts[1].codes[0].turns", "between 1 and"},
    {R"("turns": 10)", R"("turns": "10")", 51, "orderingKey.parts[1].codes[0].turns", "whole number"},
    {R"("stepsPerTurn": 7)", R"("turns": 7)", 54, "orderingKey.parts[2].codes", "turns already"},
    {R"("any": 1, "optional": true)", R"("any": 0)", 55, "orderingKey.parts[3].any", "between 1 and 20"},
    {R"("any": 1, "optional": true)", R"("optional": true)", 55, "orderingKey.parts[3].codes",
     "codes or any"},
    {R"("name": "Steps")", R"("optional": true, "name": "Steps")", 55, "orderingKey.parts[3].name",
     "last part"},
    {R"("AB-10 7.x")", R"("AB-11 7.x")", 47, "orderingKey.example", "\"11\""},
    // shared tables
    {R"("connectors": [)", R"("tablesOf": "other-k1", "connectors": [)", 21, "tablesOf", "other-k1"},
    // a serial encoder is no participant of a ring
    {R"("profile": "K1")", R"("profile": "ESC")", 7, "idCode", "serial line"},
};

INSTANTIATE_TEST_SUITE_P(Catalog, BrokenTables, testing::ValuesIn(tableBreakages));

TEST(DeviceTables, AreReadAsTheyStand)
{
    Catalog catalog;
    const auto added = catalog.add(soundTables, QStringLiteral("some.json"));
    ASSERT_TRUE(added) << added.error().reason.toStdString();
    const DeviceDescription &device = *catalog.find(u"some-k1");
    EXPECT_EQ(device.connectors[0].pins[1].signal.toString(), QStringLiteral("DI"));
    EXPECT_EQ(device.leds->states[1].blinking, QStringList{QStringLiteral("BA")});
    EXPECT_EQ(device.supply.value.toString(), QStringLiteral("24 V DC"));
    EXPECT_EQ(device.limits[0].rows[1].value.toString(), QStringLiteral("12 rpm"));
    EXPECT_EQ(device.orderingKey->parts[1].codes[0].turns, 10);
    EXPECT_TRUE(device.orderingKey->parts[3].optional);
}

TEST(DeviceTables, MayBeThoseOfAnotherDevice)
{
    Catalog catalog;
    ASSERT_TRUE(catalog.add(soundTables, QStringLiteral("some.json")));
    QByteArray json = soundTables;
    json.replace("some-k1", "some-k1-b");
    json = json.first(json.indexOf("  \"connectors\"")) +
           R"(  "tablesOf": "some-k1", "supply": {"value": "12 V", "chapter": "1"}})";
    const auto added = catalog.add(json, QStringLiteral("b.json"));
    ASSERT_TRUE(added) << added.error().reason.toStdString();
    const DeviceDescription &device = *catalog.find(u"some-k1-b");
    EXPECT_EQ(device.connectors, catalog.find(u"some-k1")->connectors);
    EXPECT_EQ(device.orderingKey, catalog.find(u"some-k1")->orderingKey);
    EXPECT_EQ(device.supply.value.toString(), QStringLiteral("12 V")); // its own goes before
}

TEST(DeviceTables, AFileComesAfterTheOneWhoseNameItsOwnBeginsWith)
{
    EXPECT_EQ(Catalog::inReadingOrder(
                  {QStringLiteral("b-k1.json"), QStringLiteral("b.json"), QStringLiteral("a.json")}),
              (QStringList{QStringLiteral("a.json"), QStringLiteral("b.json"), QStringLiteral("b-k1.json")}));
}

} // namespace
} // namespace codewheel
