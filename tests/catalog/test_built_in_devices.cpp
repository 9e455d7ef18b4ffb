// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const DeviceDescription &device(const Catalog &catalog, QStringView key)
{
    static const DeviceDescription none;
    const DeviceDescription *found = catalog.find(key);
    EXPECT_NE(found, nullptr) << key.toString().toStdString();
    return found ? *found : none;
}

// The resource is in a static library: it must reach the program all the same.
TEST(BuiltInDevices, AreLinkedIntoTheProgram)
{
    const Catalog catalog = Catalog::builtIn();
    std::vector<QString> keys;
    for (const DeviceDescription &each : catalog.devices())
        keys.push_back(each.key);
    EXPECT_EQ(keys, (std::vector{QStringLiteral("baumer-gxp6w"), QStringLiteral("fraba-ocd-ib"),
                                 QStringLiteral("fraba-ocd-ib-k1"), QStringLiteral("fraba-ocd-ib-k2"),
                                 QStringLiteral("fraba-ocd-ib-loop2"), QStringLiteral("generic-k1"),
                                 QStringLiteral("generic-k2"), QStringLiteral("generic-k3"),
                                 QStringLiteral("generic-k4"), QStringLiteral("tr-la66"),
                                 QStringLiteral("twk-k4")}));
    EXPECT_EQ(catalog.find(u"fraba"), nullptr);
}

// FRABA manual 10.1 and 10.2
TEST(BuiltInDevices, FrabaParametersAreThoseOfTheManual)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = device(catalog, u"fraba-ocd-ib");
    struct Row
    {
        Parameter parameter;
        std::optional<unsigned> number;
        std::optional<unsigned> readOut;
    };
    const Row rows[] = {
        {Parameter::steps, 1, 1},
        {Parameter::revolutions, 2, 2},
        {Parameter::direction, 3, 3},
        {Parameter::preset, 4, 4},
        {Parameter::zeroOffset, 5, 5},
        {Parameter::serialNumber, {}, 0},
        {Parameter::presetFlag, {}, 6},
        {Parameter::softwareVersion, {}, 7},
        {Parameter::operatingTime, {}, 8},
        {Parameter::startUpMode, {}, 9},
        {Parameter::multiTurnAndStepsMinusOne, {}, 0xA},
        {Parameter::temperature, {}, 0xC},
    };
    EXPECT_EQ(fraba.parameters.size(), std::size(rows) + 16); // and the OPC registers
    for (const Row &row : rows) {
        const ParameterDescription *found = fraba.find(row.parameter);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->number, row.number);
        EXPECT_EQ(found->readOut, row.readOut);
    }
    EXPECT_EQ(fraba.findNumber(1)->maximum, 33'554'431);
    EXPECT_EQ(fraba.findNumber(3)->findChoice(u"cw")->value, 3);
    EXPECT_EQ(fraba.findNumber(3)->findChoice(4)->key, QStringLiteral("ccw"));
    EXPECT_EQ(fraba.findNumber(6), nullptr);
    EXPECT_EQ(fraba.findReadOut(0xB), nullptr);
}

// FRABA manual 10.2: 202100xDh
TEST(BuiltInDevices, FrabaHasTheSixteenRegistersOfItsBusChip)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = device(catalog, u"fraba-ocd-ib");
    for (const auto &[name, code] : {std::pair("opc-register-0", 0x0Du), std::pair("opc-register-3", 0x3Du),
                                     std::pair("opc-register-15", 0xFDu)}) {
        const ParameterDescription *found = fraba.findReadOut(code);
        ASSERT_NE(found, nullptr) << name;
        EXPECT_EQ(parameterKey(found->parameter), QLatin1String(name));
        EXPECT_FALSE(found->number);
        EXPECT_EQ(found->maximum, 0xFFFF);
    }
    const std::vector<Parameter> byItself = fraba.readableValues();
    EXPECT_EQ(byItself.size(), 12u) << "a read of everything leaves the registers out";
}

TEST(BuiltInDevices, FrabaCanReadAndHasAnEepromBudget)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = device(catalog, u"fraba-ocd-ib");
    EXPECT_EQ(fraba.fullName(), QStringLiteral("FRABA OCD-IB K3"));
    EXPECT_EQ(fraba.idCode, 0x37u);
    EXPECT_EQ(fraba.deviceCode, 0x0237u);
    EXPECT_EQ(fraba.dialect, k3::Dialect::fraba);
    EXPECT_EQ(fraba.physicalStepsPerTurn, 8192);
    EXPECT_EQ(fraba.physicalTurns, 4096);
    const Capabilities &can = fraba.capabilities;
    EXPECT_TRUE(can.reads && can.writes && can.presets && can.cams && can.serialNumber);
    EXPECT_TRUE(can.velocity && can.manufacturerPreset && can.resets);
    EXPECT_TRUE(can.readingHidesPosition && can.presetIsStored);
    EXPECT_FALSE(can.hasBattery);
    EXPECT_EQ(can.eepromBudget, 200);
    EXPECT_EQ(can.eepromLimit, 500);
    EXPECT_TRUE(fraba.quirks.confirmsWhileProcessing && fraba.quirks.presetNeedsRearming);
    EXPECT_TRUE(fraba.quirks.mayCountStepsMinusOne && fraba.quirks.hasModes);
    EXPECT_EQ(fraba.errors.size(), 4u);
}

// Baumer manual 5 and 7
TEST(BuiltInDevices, BaumerParametersAndErrorsAreThoseOfTheManual)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &baumer = device(catalog, u"baumer-gxp6w");
    struct Row
    {
        unsigned number;
        Parameter parameter;
        std::int64_t minimum;
        std::int64_t maximum;
        std::int64_t factory;
    };
    const Row rows[] = {
        {1, Parameter::steps, 1, 33'554'431, 8192},
        {2, Parameter::revolutions, 1, 4096, 1},
        {3, Parameter::coding, 1, 6, 3},
        {4, Parameter::preset, 0, 33'554'431, 0},
        {5, Parameter::zeroOffset, 0, 33'554'431, 0},
        {6, Parameter::offset, 0, 33'554'431, 0},
        {15, Parameter::measuringRange, 1, 4096, 4096},
    };
    EXPECT_EQ(baumer.parameters.size(), std::size(rows));
    for (const Row &row : rows) {
        const ParameterDescription *found = baumer.findNumber(row.number);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->parameter, row.parameter);
        EXPECT_EQ(found->minimum, row.minimum);
        EXPECT_EQ(found->maximum, row.maximum);
        EXPECT_EQ(found->factory, row.factory);
        EXPECT_FALSE(found->readOut);
    }
    EXPECT_EQ(baumer.find(Parameter::coding)->findChoice(u"unsigned-cw")->value, 3);
    EXPECT_EQ(baumer.find(Parameter::coding)->findChoice(u"gray-ccw")->value, 6);
    EXPECT_EQ(baumer.findError(13)->meaning, RefusalId::eepromStoreError);
    EXPECT_TRUE(baumer.findError(14)->warning);
    EXPECT_FALSE(baumer.findError(15)->warning);
    EXPECT_EQ(baumer.findError(4), nullptr);
}

TEST(BuiltInDevices, BaumerCannotReadAndStatesNoBudget)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &baumer = device(catalog, u"baumer-gxp6w");
    EXPECT_FALSE(baumer.capabilities.reads);
    EXPECT_FALSE(baumer.capabilities.serialNumber);
    EXPECT_FALSE(baumer.capabilities.presetIsStored);
    EXPECT_TRUE(baumer.capabilities.writes && baumer.capabilities.hasBattery);
    EXPECT_TRUE(baumer.capabilities.resets);
    EXPECT_FALSE(baumer.capabilities.velocity || baumer.capabilities.manufacturerPreset);
    EXPECT_FALSE(baumer.capabilities.eepromBudget);
    EXPECT_EQ(baumer.quirks, Quirks{});
    EXPECT_TRUE(baumer.notesText().contains(QStringLiteral("assumed")));
}

// LA-66 manual 1 and 3. Number and read-out code are the service that writes and the one that reads.
TEST(BuiltInDevices, ServicesOfTheRodAreThoseOfTheManual)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &rod = device(catalog, u"tr-la66");
    EXPECT_EQ(rod.profile, Profile::la66);
    EXPECT_EQ(rod.deviceCode, 0x0233u);
    struct Row
    {
        Parameter parameter;
        std::optional<unsigned> number;
        std::optional<unsigned> readOut;
        std::int64_t minimum;
        std::int64_t maximum;
    };
    const Row rows[] = {
        {Parameter::direction, 1, 1, 0, 1},
        {Parameter::measuringLength, 2, 2, 1, 0xFF'FFFF},
        {Parameter::externalPreset, 4, 4, 0, 0xFF'FFFF},
        {Parameter::errorStatus, {}, 8, 0, 0xFFFF},
    };
    for (const Row &row : rows) {
        const ParameterDescription *found = rod.find(row.parameter);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->number, row.number);
        EXPECT_EQ(found->readOut, row.readOut);
        EXPECT_EQ(found->minimum, row.minimum);
        EXPECT_EQ(found->maximum, row.maximum);
    }
    EXPECT_TRUE(rod.find(Parameter::rodLength)->onLabel);
    EXPECT_EQ(rod.parameters.size(), std::size(rows) + 1);
    EXPECT_TRUE(rod.capabilities.presetNeedsValue);
    EXPECT_FALSE(rod.capabilities.eepromBudget);
    EXPECT_EQ(rod.findError(5)->meaning, RefusalId::magnetOutOfRange);
}

// 33h is the ID code of analog modules too: an unnamed one is no encoder.
TEST(BuiltInDevices, AnUnnamed0233hIsNotTakenForARod)
{
    EXPECT_EQ(Catalog::builtIn().generic(0x0233), nullptr);
}

TEST(BuiltInDevices, NotesAreInEachLanguage)
{
    const Catalog catalog = Catalog::builtIn();
    for (const DeviceDescription &device : catalog.devices())
        EXPECT_EQ(device.notes.keys(), (QStringList{QStringLiteral("de"), QStringLiteral("en")}))
            << qPrintable(device.key);
}

TEST(BuiltInDevices, AnUnnamed0237hIsTheGenericK3)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription *generic = catalog.generic(0x0237);
    ASSERT_NE(generic, nullptr);
    EXPECT_EQ(generic->key, QStringLiteral("generic-k3"));
    EXPECT_EQ(generic->fullName(), QStringLiteral("K3, make not known"));
    EXPECT_TRUE(generic->isGeneric());
    EXPECT_FALSE(generic->capabilities.reads || generic->capabilities.resets);
    EXPECT_EQ(generic->findNumber(3), nullptr); // direction at one make, coding at another
    EXPECT_EQ(generic->findNumber(5)->parameter, Parameter::zeroOffset);
    EXPECT_EQ(catalog.generic(0x0133), nullptr);
}

// FRABA manual 2.2; TWK, table VI
TEST(BuiltInDevices, WhatOnlyTellsItsPositionHasTheCodesAndWordsOfItsProfile)
{
    const Catalog catalog = Catalog::builtIn();
    struct Row
    {
        QStringView key;
        Profile profile;
        unsigned idCode;
        unsigned deviceCode;
        int inWords;
        int outWords;
        int stepsPerTurn;
        int turns;
    };
    const Row rows[] = {
        {u"fraba-ocd-ib-k1", Profile::k1, 54, 0x0136, 1, 0, 4096, 1},
        {u"fraba-ocd-ib-k2", Profile::k2, 54, 0x0236, 2, 0, 4096, 4096},
        {u"generic-k1", Profile::k1, 54, 0x0136, 1, 0, 0, 0},
        {u"generic-k2", Profile::k2, 54, 0x0236, 2, 0, 0, 0},
        {u"generic-k4", Profile::k4, 247, 0x03F7, 2, 2, 0, 0},
        {u"twk-k4", Profile::k4, 247, 0x03F7, 2, 2, 0, 0},
    };
    for (const Row &row : rows) {
        const DeviceDescription &found = device(catalog, row.key);
        EXPECT_EQ(found.profile, row.profile) << qPrintable(found.key);
        EXPECT_EQ(found.idCode, row.idCode) << qPrintable(found.key);
        EXPECT_EQ(found.deviceCode, row.deviceCode) << qPrintable(found.key);
        EXPECT_EQ(found.inWords, row.inWords) << qPrintable(found.key);
        EXPECT_EQ(found.outWords, row.outWords) << qPrintable(found.key);
        EXPECT_EQ(found.physicalStepsPerTurn, row.stepsPerTurn) << qPrintable(found.key);
        EXPECT_EQ(found.physicalTurns, row.turns) << qPrintable(found.key);
        EXPECT_EQ(found.coding, PositionCoding::binary) << qPrintable(found.key);
        EXPECT_FALSE(found.capabilities.reads || found.capabilities.writes || found.capabilities.presets)
            << qPrintable(found.key);
    }
    EXPECT_EQ(catalog.generic(0x0136)->fullName(), QStringLiteral("K1, make not known"));
    EXPECT_EQ(catalog.generic(0x03F7)->fullName(), QStringLiteral("K4, make not known"));
}

// FRABA manual 2.2: on Loop 2 it is the same K3 with another ID code.
TEST(BuiltInDevices, TheLoop2EncoderDiffersInNothingButItsCodes)
{
    const Catalog catalog = Catalog::builtIn();
    DeviceDescription loop = device(catalog, u"fraba-ocd-ib-loop2");
    EXPECT_EQ(loop.idCode, 179U);
    EXPECT_EQ(loop.deviceCode, 0x02B3U);
    EXPECT_EQ(loop.fullName(), QStringLiteral("FRABA OCD-IB K3 Loop 2"));
    const DeviceDescription &standard = device(catalog, u"fraba-ocd-ib");
    loop.key = standard.key;
    loop.name = standard.name;
    loop.idCode = standard.idCode;
    loop.deviceCode = standard.deviceCode;
    EXPECT_EQ(loop, standard);
}

} // namespace
} // namespace codewheel
