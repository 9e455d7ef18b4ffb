// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/protocol_rules.h"
#include "catalog/value_text.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/encoder_bits.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using canopen::ObjectType;

QByteArray withRow(const QByteArray &row, const QByteArray &head = {})
{
    return R"({"key": "node", "vendor": "Somebody", "name": "N", "manual": "M", "profile": "CiA-406",)" +
           head + R"("physicalStepsPerTurn": 0, "physicalTurns": 0, "parameters": [)" + row +
           R"(], "errors": [], "capabilities": {"presets": false, "cams": false, "readingHidesPosition": false,
              "presetIsStored": false, "hasBattery": false},
              "quirks": {"confirmsWhileProcessing": false, "presetNeedsRearming": false,
              "mayCountStepsMinusOne": false, "hasModes": false}})";
}

// The key of the fault; empty: there is none.
QString faultOf(const QByteArray &json)
{
    Catalog catalog;
    const auto added = catalog.add(json, QStringLiteral("node.json"));
    return added ? QString() : added.error().key;
}

TEST(CanopenRules, ParametersAreObjects)
{
    Catalog catalog;
    ASSERT_TRUE(catalog.add(withRow(R"({"parameter": "serial-number", "object": "1018:4", "type": "u32",
        "minimum": 0, "maximum": 4294967295},
        {"parameter": "direction", "object": "6000", "type": "u16", "bit": 0, "access": "rw", "minimum": 0,
        "maximum": 1})"),
                            QStringLiteral("node.json")));
    const DeviceDescription &node = catalog.devices().front();
    EXPECT_EQ(node.profile, profile::cia406);
    EXPECT_FALSE(node.hasWords());
    const ParameterDescription *serial = node.find(Parameter::serialNumber);
    EXPECT_TRUE(serial->canBeRead && !serial->canBeWritten);
    EXPECT_EQ(canopenReach(*serial)->object, (canopen::SdoObject{0x1018, 4}));
    const ProtocolRules &rules = protocolRules(node.profile);
    EXPECT_EQ(rules.reachText(*node.find(Parameter::direction)).write, QStringLiteral("6000h:0, bit 0"));
    EXPECT_TRUE(rules.storesByStep());
}

TEST(CanopenRules, WhatIsWrongIsRefused)
{
    const QByteArray limits = R"("minimum": 0, "maximum": 1})";
    const std::pair<QByteArray, const char *> rows[] = {
        {R"({"parameter": "steps", "object": "60012", "type": "u32",)", "parameters[0].object"},
        {R"({"parameter": "steps", "object": "6001", "type": "u24",)", "parameters[0].type"},
        {R"({"parameter": "steps", "object": "6003", "type": "u32",)", "parameters[0].object"},
        {R"({"parameter": "direction", "object": "6000", "type": "u16", "bit": 2,)", "parameters[0].bit"},
        {R"({"parameter": "2000", "name": "N", "object": "2000", "type": "u8", "access": "rw",)",
         "parameters[0].access"},
        {R"({"parameter": "1010:1", "name": "N", "object": "1010:1", "type": "u32", "access": "rw",)",
         "parameters[0].access"},
        {R"({"parameter": "preset", "object": "6003", "type": "u32", "access": "rw",)",
         "parameters[0].access"},
        {R"({"parameter": "steps", "number": 1,)", "parameters[0].number"},
    };
    for (const auto &[row, key] : rows)
        EXPECT_EQ(faultOf(withRow(row + limits)), QLatin1String(key)) << row.toStdString();
    EXPECT_EQ(faultOf(withRow(R"({"parameter": "2000", "name": "N", "object": "2000", "type": "u8",
                                 "access": "rw", "minimum": 0, "maximum": 1})",
                              R"("vendorNumber": "10Dh",)")),
              QString());
}

TEST(CanopenRules, TheObjectOfTheNodeNumberIsOneOfTheMaker)
{
    const QByteArray row =
        R"({"parameter": "steps", "object": "6001", "type": "u32", "minimum": 1, "maximum": 2})";
    EXPECT_EQ(faultOf(withRow(row, R"("vendorNumber": "10Dh", "nodeNumberObject": "2000",)")), QString());
    for (const char *key :
         {R"("nodeNumberObject": "2000",)", R"("vendorNumber": "10Dh", "nodeNumberObject": "6001",)",
          R"("vendorNumber": "10Dh", "nodeNumberObject": "number",)"})
        EXPECT_EQ(faultOf(withRow(row, key)), QStringLiteral("nodeNumberObject")) << key;
}

TEST(CanopenRules, RatesWithNumbersOfTheirOwnNeedAMake)
{
    const QByteArray row =
        R"({"parameter": "steps", "object": "6001", "type": "u32", "minimum": 1, "maximum": 2})";
    const QByteArray rates = R"("rates": [{"number": 5, "rate": 100000}],)";
    const QByteArray vendor = R"("vendorNumber": "10Dh",)";
    EXPECT_EQ(faultOf(withRow(row, vendor + rates)), QString());
    EXPECT_EQ(faultOf(withRow(row, vendor + rates + R"("rateObject": "3001",)")), QString());
    EXPECT_EQ(faultOf(withRow(row, rates)), QStringLiteral("rates"));
    EXPECT_EQ(faultOf(withRow(row, vendor + R"("rateObject": "3001",)")), QStringLiteral("rateObject"));
    EXPECT_EQ(faultOf(withRow(row, vendor + rates + R"("rateObject": "6001",)")),
              QStringLiteral("rateObject"));
    EXPECT_EQ(faultOf(withRow(row, vendor + R"("rates": [{"number": 5, "rate": 100000},
                                                     {"number": 5, "rate": 50000}],)")),
              QStringLiteral("rates[1].rate"));
}

TEST(CanopenRules, ObjectsAreOfCanopenOnly)
{
    QByteArray json =
        withRow(R"({"parameter": "steps", "read": "D", "object": "6001", "minimum": 1, "maximum": 2})");
    json.replace("CiA-406", "ESC");
    EXPECT_EQ(faultOf(json), QStringLiteral("parameters[0].object"));
}

TEST(CanopenRules, TheBuiltInOnesAreGenericForNoRing)
{
    const Catalog catalog = Catalog::builtIn();
    for (const char *key : {"canopen-406-single-turn", "canopen-406-multi-turn", "canopen-406-linear"}) {
        const DeviceDescription *device = catalog.find(QString::fromLatin1(key));
        ASSERT_NE(device, nullptr);
        EXPECT_TRUE(device->isGeneric());
        EXPECT_EQ(isRod(*device), QLatin1String(key) == QLatin1String("canopen-406-linear"));
    }
    EXPECT_EQ(catalog.generic(0), nullptr);
}

// CiA 406; 6000h and 6500h, 6503h, 6505h.
TEST(CanopenRules, BitsHaveTheirNames)
{
    EXPECT_EQ(canopen::encoderBitTexts(0x6500, 0x0005).join(u'|'), QStringLiteral("scaling on|CCW"));
    EXPECT_EQ(canopen::encoderBitTexts(0x6500, 0x0000).join(u'|'), QStringLiteral("scaling off|CW"));
    EXPECT_EQ(canopen::encoderBitTexts(0x6503, 0x1001).join(u'|'),
              QStringLiteral("bit 12 (of the maker)|position error"));
    EXPECT_EQ(canopen::encoderBitTexts(0x6505, 0x0092).join(u'|'),
              QStringLiteral("bit 7 (not described)|battery charge low|light reserve used up"));
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription *device = catalog.find(u"canopen-406-multi-turn");
    EXPECT_EQ(valueText(*device->find(Parameter::warnings), 0x0001),
              QStringLiteral("0001h (frequency exceeded)"));
    EXPECT_EQ(valueText(*device->find(Parameter::alarms), 0), QStringLiteral("0000h (none)"));
    EXPECT_EQ(valueText(*device->find(Parameter::of(u"6400:1")), 0x03),
              QStringLiteral("03h (above the work area, outside the work area)"));
    EXPECT_EQ(valueText(*device->find(Parameter::of(u"6400:1")), 0), QStringLiteral("00h (none)"));
}

// A description may say what the bits of its maker mean.
TEST(CanopenRules, BitsHaveTheNamesOfTheDescription)
{
    Catalog catalog;
    const auto added = catalog.add(
        withRow(R"({"parameter": "6503b12", "name": {"en": "Battery empty", "de": "Batterie leer"},
                    "object": "6503", "type": "u16", "bit": 12, "minimum": 0, "maximum": 1})"),
        QStringLiteral("d.json"));
    ASSERT_TRUE(added);
    EXPECT_EQ(canopen::encoderBitTexts(catalog.devices().front(), 0x6503, 0x3001).join(u'|'),
              QStringLiteral("bit 13 (of the maker)|Battery empty|position error"));
}

// 6507h: profile low, high, software low, high.
TEST(CanopenRules, VersionsAndOperatingTimeAreToldInWords)
{
    const Catalog catalog = Catalog::builtIn();
    for (const char *key : {"canopen-406-single-turn", "canopen-406-multi-turn", "canopen-406-linear"}) {
        const DeviceDescription *device = catalog.find(QString::fromLatin1(key));
        EXPECT_EQ(valueText(*device->find(Parameter::of(u"6507")), 0x0504'0302),
                  QStringLiteral("05040302h (profile 3.2, software 5.4)"));
        const ParameterDescription &hours = *device->find(Parameter::operatingTime);
        EXPECT_EQ(valueText(hours, 12'876), QStringLiteral("1287.6"));
        EXPECT_EQ(unitText(hours, 12'876), QStringLiteral("h"));
        EXPECT_EQ(valueText(hours, 0xFFFF'FFFF), QStringLiteral("not supported"));
        EXPECT_EQ(unitText(hours, 0xFFFF'FFFF), QString());
    }
}

struct ValueRow
{
    ObjectType type;
    std::vector<std::uint8_t> octets;
    std::int64_t value;
};

TEST(ObjectValue, HasTheWidthOfTheAnswerAndTheSignOfItsType)
{
    for (const ValueRow &row : {
             ValueRow{ObjectType::u32, {0x88, 0x13, 0, 0}, 5000},
             ValueRow{ObjectType::u32, {0xFF, 0xFF, 0xFF, 0xFF}, 4294967295},
             ValueRow{ObjectType::i32, {0xFF, 0xFF, 0xFF, 0xFF}, -1},
             ValueRow{ObjectType::i32, {0xFE, 0xFF}, -2}, // narrower than usual
             ValueRow{ObjectType::u16, {0xFE, 0xFF, 0x01, 0}, 0x1FFFE},
             ValueRow{ObjectType::i16, {0x2E, 0xFB}, -1234},
         })
        EXPECT_EQ(canopen::objectValue(row.type, row.octets), Value(row.value));
    const std::vector<std::uint8_t> untold{0xFE, 0xFF, 0x77, 0x77}; // 42h: four octets, of which two count
    EXPECT_EQ(canopen::objectValue(ObjectType::i16, untold, false), Value(-2));
    const std::vector<std::uint8_t> text{'T', 'W', 'K', 0, 0};
    EXPECT_EQ(canopen::objectValue(ObjectType::text, text), Value(QStringLiteral("TWK")));
    EXPECT_EQ(canopen::octetsOf(Value(-2), 2), (std::vector<std::uint8_t>{0xFE, 0xFF}));
    EXPECT_EQ(canopen::octetsOf(Value(5000), 4), (std::vector<std::uint8_t>{0x88, 0x13, 0, 0}));
}

} // namespace
} // namespace codewheel
