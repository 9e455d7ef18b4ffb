// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/protocol/esc_reach.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/profiles.h"
#include "kinds/interbus/words/word_reach.h"

#include <QDir>

#include <algorithm>
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

// The resource is in a static library, but must still reach the program. It must contain each file of the
// folder, named after its key.
TEST(BuiltInDevices, AreLinkedIntoTheProgram)
{
    const Catalog catalog = Catalog::builtIn();
    QStringList keys;
    for (const DeviceDescription &each : catalog.devices())
        keys << each.key + QStringLiteral(".json");
    QStringList files = QDir(QStringLiteral(CODEWHEEL_ROOT "/resources/devices")).entryList(QDir::Files);
    files.sort();
    keys.sort();
    EXPECT_EQ(keys, files);
    EXPECT_TRUE(keys.contains(QStringLiteral("fraba-ocd-ib.json")));
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
        EXPECT_EQ(wordReach(*found).number, row.number);
        EXPECT_EQ(wordReach(*found).readOut, row.readOut);
    }
    EXPECT_EQ(findNumber(fraba, 1)->maximum, 33'554'431);
    EXPECT_EQ(findNumber(fraba, 3)->findChoice(u"cw")->value, 3);
    EXPECT_EQ(findNumber(fraba, 3)->findChoice(4)->key, QStringLiteral("ccw"));
    EXPECT_EQ(findNumber(fraba, 6), nullptr);
    EXPECT_EQ(findReadOut(fraba, 0xB), nullptr);
}

// FRABA manual 10.2: 202100xDh
TEST(BuiltInDevices, FrabaHasTheSixteenRegistersOfItsBusChip)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = device(catalog, u"fraba-ocd-ib");
    for (const auto &[name, code] : {std::pair("opc-register-0", 0x0Du), std::pair("opc-register-3", 0x3Du),
                                     std::pair("opc-register-15", 0xFDu)}) {
        const ParameterDescription *found = findReadOut(fraba, code);
        ASSERT_NE(found, nullptr) << name;
        EXPECT_EQ(parameterKey(found->parameter), QLatin1String(name));
        EXPECT_FALSE(found->canBeWritten);
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
        const ParameterDescription *found = findNumber(baumer, row.number);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->parameter, row.parameter);
        EXPECT_EQ(found->minimum, row.minimum);
        EXPECT_EQ(found->maximum, row.maximum);
        EXPECT_EQ(found->factory, row.factory);
        EXPECT_FALSE(found->canBeRead);
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

// All texts of a description; those that are the same in every language have the language "".
std::vector<LocalText> textsOf(const DeviceDescription &device)
{
    std::vector<LocalText> texts{device.notes, device.supply.value, device.supply.chapter};
    for (const ParameterDescription &parameter : device.parameters)
        texts.push_back(parameter.chapter);
    for (const DeviceError &error : device.errors)
        texts.push_back(error.text);
    for (const Connector &connector : device.connectors) {
        texts.insert(texts.end(), {connector.name, connector.chapter});
        for (const Pin &pin : connector.pins)
            texts.insert(texts.end(), {pin.signal, pin.remark});
    }
    for (const Led &lamp : device.leds.value_or(Leds{}).lamps)
        texts.insert(texts.end(), {lamp.colour, lamp.meaning});
    for (const LedState &state : device.leds.value_or(Leds{}).states)
        texts.push_back(state.meaning);
    for (const LimitTable &table : device.limits) {
        texts.insert(texts.end(), {table.name, table.chapter});
        for (const LimitTable::Row &row : table.rows)
            texts.insert(texts.end(), {row.name, row.value});
    }
    for (const OrderingKey::Part &part : device.orderingKey.value_or(OrderingKey{}).parts) {
        texts.push_back(part.name);
        for (const OrderingKey::Code &code : part.codes)
            texts.push_back(code.meaning);
    }
    return texts;
}

TEST(BuiltInDevices, EveryTextIsInEachLanguage)
{
    const QStringList both{QStringLiteral("de"), QStringLiteral("en")};
    const Catalog catalog = Catalog::builtIn();
    for (const DeviceDescription &device : catalog.devices()) {
        EXPECT_EQ(device.notes.byLanguage.keys(), both) << qPrintable(device.key);
        for (const LocalText &text : textsOf(device)) {
            if (!text.isEmpty() && !text.byLanguage.contains(QString())) {
                EXPECT_EQ(text.byLanguage.keys(), both)
                    << qPrintable(device.key) << ": " << qPrintable(text.toString());
            }
        }
    }
}

// FRABA manual 3.1, 3.3 and 6; Baumer 8.6: wrong wiring destroys an encoder.
TEST(BuiltInDevices, SupplyAndItsPinsAreThoseOfTheManuals)
{
    const auto signalAt = [](const Connector &connector, const char *pin) {
        const auto found = std::ranges::find(connector.pins, QLatin1String(pin), &Pin::pin);
        return found == connector.pins.end() ? std::string("none") : found->signal.toString().toStdString();
    };
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = device(catalog, u"fraba-ocd-ib");
    ASSERT_EQ(fraba.connectors.size(), 2u);
    for (const Connector &connector : fraba.connectors) {
        EXPECT_EQ(connector.pins.size(), 9u);
        EXPECT_EQ(signalAt(connector, "7"), "+ 12-30 V DC");
        EXPECT_EQ(signalAt(connector, "8"), "GND (0 V)");
    }
    EXPECT_TRUE(fraba.supply.value.toString().startsWith(QStringLiteral("10 - 30 V DC")));
    ASSERT_EQ(fraba.leds->lamps.size(), 4u);
    ASSERT_EQ(fraba.leds->states.size(), 4u);
    EXPECT_EQ(fraba.leds->states[1].blinking, QStringList{QStringLiteral("BA")});

    const DeviceDescription &baumer = device(catalog, u"baumer-gxp6w");
    ASSERT_EQ(baumer.connectors.size(), 4u);
    EXPECT_EQ(signalAt(baumer.connectors[0], "1"), "D01");
    EXPECT_EQ(signalAt(baumer.connectors[0], "7"), "UB");
    EXPECT_EQ(signalAt(baumer.connectors[0], "9"), "-");
    EXPECT_EQ(signalAt(baumer.connectors[1], "1"), "/D02");
    EXPECT_EQ(signalAt(baumer.connectors[1], "9"), "RBST");
}

// Kübler 1: the two interfaces differ from pin 3 on.
TEST(BuiltInDevices, KueblerIsKnownByItsLabelAndItsTables)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &rs485 = device(catalog, u"kuebler-esc-rs485");
    const DeviceDescription &rs422 = device(catalog, u"kuebler-esc-rs422");
    EXPECT_EQ(rs485.profile, profile::esc);
    EXPECT_EQ(rs485.deviceCode, 0u);
    EXPECT_EQ(catalog.generic(0), nullptr);
    EXPECT_EQ(rs485.connectors[0].pins[2].signal.toString(), QStringLiteral("T/R-"));
    EXPECT_EQ(rs422.connectors[0].pins[2].signal.toString(), QStringLiteral("R+"));
    EXPECT_TRUE(rs422.connectors[0].pins[6].remark.toString().contains(QStringLiteral("+UB")));
}

// Kübler, "Read only parameters" and "Programmable parameters"
TEST(BuiltInDevices, KueblerParametersAreTheCommandsOfTheManual)
{
    const Catalog catalog = Catalog::builtIn();
    struct Row
    {
        Parameter parameter;
        const char *read;
        const char *write;
        std::int64_t minimum;
        std::int64_t maximum;
        std::optional<unsigned> bit = {};
    };
    const Row rows[] = {
        {Parameter::steps, "D", "GR", 1, 8192},
        {Parameter::revolutions, "U", "GM", 1, 4096},
        {Parameter::measuringRange, "M", "GT", 1, 33'554'431},
        {Parameter::scalingFactor, "F", "GF", 0x14F9, 0x2000'0000},
        {Parameter::scaling, "O", "GS", 0, 1, 2},
        {Parameter::direction, "O", "GD", 0, 1, 0},
        {Parameter::lowerLimit, "L", "GL", 1, 33'554'431},
        {Parameter::upperLimit, "H", "GH", 1, 33'554'431},
        {Parameter::lineAddress, "", "X", 1, 31},
        {Parameter::baudRate, "", "Y", 4800, 19200},
        {Parameter::preset, "S", "", 1, 33'554'431},
        {Parameter::offset, "C", "", 0, 0xFFFF'FFFF},
        {Parameter::serialNumber, "N", "", 0, 0xFFFF'FFFF},
        {Parameter::operatingTime, "T", "", 0, 0xFFFF'FFFF},
        {Parameter::operatingParameters, "O", "", 0, 0xFFFF},
        {Parameter::alarms, "A", "", 0, 0xFFFF},
        {Parameter::warnings, "E", "", 0, 0xFFFF},
        {Parameter::deviceCode, "B", "", 0x8000, 0xA000},
    };
    for (const QStringView key : {u"kuebler-esc-rs485", u"kuebler-esc-rs422"}) {
        const DeviceDescription &kuebler = device(catalog, key);
        EXPECT_EQ(kuebler.parameters.size(), std::size(rows));
        for (const Row &row : rows) {
            const ParameterDescription *found = kuebler.find(row.parameter);
            ASSERT_NE(found, nullptr);
            EXPECT_EQ(escReach(*found), (EscReach{row.read, row.bit, row.write})) << row.read;
            EXPECT_EQ(found->minimum, row.minimum);
            EXPECT_EQ(found->maximum, row.maximum);
        }
        const Capabilities &can = kuebler.capabilities;
        EXPECT_TRUE(can.reads && can.writes && can.presets && can.presetNeedsValue && can.serialNumber);
        EXPECT_FALSE(can.readingHidesPosition || can.cams || can.resets || can.velocity);
        EXPECT_EQ(kuebler.find(Parameter::direction)->findChoice(u"ccw")->value, 1);
    }
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
    EXPECT_EQ(findNumber(*generic, 3), nullptr); // direction for one make, coding for another
    EXPECT_EQ(findNumber(*generic, 5)->parameter, Parameter::zeroOffset);
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
        {u"fraba-ocd-ib-k1", profile::k1, 54, 0x0136, 1, 0, 4096, 1},
        {u"fraba-ocd-ib-k2", profile::k2, 54, 0x0236, 2, 0, 4096, 4096},
        {u"fraba-ocd-ib-k1-loop2", profile::k1, 178, 0x01B2, 1, 0, 4096, 1},
        {u"fraba-ocd-ib-k2-loop2", profile::k2, 178, 0x02B2, 2, 0, 4096, 4096},
        {u"generic-k1", profile::k1, 54, 0x0136, 1, 0, 0, 0},
        {u"generic-k2", profile::k2, 54, 0x0236, 2, 0, 0, 0},
        {u"generic-k1-loop2", profile::k1, 178, 0x01B2, 1, 0, 0, 0},
        {u"generic-k2-loop2", profile::k2, 178, 0x02B2, 2, 0, 0, 0},
        {u"generic-k4", profile::k4, 247, 0x03F7, 2, 2, 0, 0},
        {u"twk-k4", profile::k4, 247, 0x03F7, 2, 2, 0, 0},
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
    loop.notes = standard.notes; // of the fibre optics
    loop.idCode = standard.idCode;
    loop.deviceCode = standard.deviceCode;
    // plugs, LEDs and label are those of the standard encoder alone (3.1, 3.3, 8)
    EXPECT_TRUE(loop.connectors.empty());
    EXPECT_FALSE(loop.leds || loop.orderingKey);
    loop.connectors = standard.connectors;
    loop.leds = standard.leds;
    loop.supply = standard.supply;
    loop.limits = standard.limits;
    loop.orderingKey = standard.orderingKey;
    EXPECT_EQ(loop, standard);
}

// FRABA manual 2.2: ID codes of Loop 2
TEST(BuiltInDevices, AnUnnamedEncoderOfLoop2IsThatOfTheRemoteBusWithOtherCodes)
{
    const Catalog catalog = Catalog::builtIn();
    struct Row
    {
        unsigned loopCode;
        unsigned busCode;
        const char *fullName;
    };
    const Row rows[] = {
        {0x01B2, 0x0136, "K1 Loop 2, make not known"},
        {0x02B2, 0x0236, "K2 Loop 2, make not known"},
        {0x02B3, 0x0237, "K3 Loop 2, make not known"},
    };
    for (const Row &row : rows) {
        const DeviceDescription *loop = catalog.generic(row.loopCode);
        const DeviceDescription *standard = catalog.generic(row.busCode);
        ASSERT_TRUE(loop && standard) << row.fullName;
        EXPECT_EQ(loop->fullName(), QLatin1String(row.fullName));
        DeviceDescription expected = *standard;
        expected.key = loop->key;
        expected.name = loop->name;
        expected.idCode = row.loopCode & 0xFF;
        expected.deviceCode = row.loopCode;
        EXPECT_EQ(*loop, expected) << row.fullName;
    }
}

} // namespace
} // namespace codewheel
