// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/esc/protocol/esc_reach.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// The parts of a description that depend on its profile.
struct Parts
{
    const char *profile;
    const char *idCode;
    const char *deviceCode;
    int inWords;
    int outWords;
    const char *parameters = "";
    const char *capability = R"("hasBattery": false)";
    const char *quirk = R"("hasModes": false)";
};

QByteArray description(const Parts &parts)
{
    const QString json =
        QStringLiteral(R"({
  "key": "some", "vendor": "Some", "name": "K", "manual": "a manual",
  "profile": %1, "idCode": "%2", "deviceCode": "%3", "inWords": %4, "outWords": %5,
  "physicalStepsPerTurn": 0, "physicalTurns": 0, "parameters": [%6], "errors": [],
  "capabilities": {"presets": false, "cams": false, "readingHidesPosition": false, "presetIsStored": false,
    "hasBattery": false},
  "quirks": {"confirmsWhileProcessing": false, "presetNeedsRearming": false, "mayCountStepsMinusOne": false,
    "hasModes": false}
})")
            .arg(QLatin1String(parts.profile), QLatin1String(parts.idCode), QLatin1String(parts.deviceCode))
            .arg(parts.inWords)
            .arg(parts.outWords)
            .arg(QLatin1String(parts.parameters));
    // The capability in question replaces "false", or is added.
    const QByteArray capability(parts.capability);
    const QByteArray denied = capability.split(':').front() + ": false";
    const QByteArray quirk(parts.quirk);
    QByteArray result = json.toUtf8().replace(quirk.split(':').front() + ": false", quirk);
    if (result.contains(denied))
        return result.replace(denied, capability);
    return result.replace(R"("hasBattery": false)", R"("hasBattery": false, )" + capability);
}

constexpr auto baumer = R"("K3", "dialect": "baumer")";
constexpr auto fraba = R"("K3", "dialect": "fraba")";
constexpr auto generic = R"("K3", "dialect": "generic")";
constexpr auto k1 = R"("K1")";
constexpr auto k2 = R"("K2")";
constexpr auto k4 = R"("K4")";
constexpr auto rod = R"("LA-66")";
constexpr auto noCapability = R"("hasBattery": false)";
constexpr auto hasModes = R"("hasModes": true)";
constexpr auto noQuirk = R"("hasModes": false)";
constexpr auto rearming = R"("presetNeedsRearming": true)";
constexpr auto minusOne = R"("mayCountStepsMinusOne": true)";
constexpr auto writable = R"({"parameter": "steps", "number": 1, "minimum": 1, "maximum": 2})";
constexpr auto readable = R"({"parameter": "steps", "readOut": 1, "minimum": 1, "maximum": 2})";
constexpr auto preset = R"({"parameter": "preset", "number": 4, "minimum": 0, "maximum": 9})";
constexpr auto presetReadOut = R"({"parameter": "preset", "readOut": 4, "minimum": 0, "maximum": 9})";
constexpr auto wholePreset =
    R"({"parameter": "preset", "number": 4, "readOut": 4, "minimum": 0, "maximum": 9})";
constexpr auto flag =
    R"({"parameter": "multi-turn-steps-minus-1", "readOut": 10, "minimum": 0, "maximum": 3})";
constexpr auto rodDirection =
    R"({"parameter": "direction", "number": 1, "readOut": 1, "minimum": 0, "maximum": 1})";
constexpr auto onLabel = R"({"parameter": "steps", "onLabel": true, "minimum": 1, "maximum": 2})";

// FRABA manual 2.2; TWK, table VI; LA-66 manual 1
TEST(DescriptionRules, TakeEachProfileWithItsCodesAndWords)
{
    const Parts sound[] = {
        {k1, "36h", "0136h", 1, 0},
        {k1, "B2h", "01B2h", 1, 0},
        {R"("K2", "coding": "signed")", "36h", "0236h", 2, 0},
        {k2, "B2h", "02B2h", 2, 0, onLabel},
        {generic, "37h", "0237h", 2, 2, preset, R"("presets": true)"},
        {baumer, "37h", "0237h", 2, 2, writable, R"("resets": true)"},
        {fraba, "B3h", "02B3h", 2, 2, readable, R"("cams": true)", hasModes},
        {fraba, "37h", "0237h", 2, 2, "", R"("cams": {"programs": 4, "cyclic": false})", hasModes},
        {fraba, "37h", "0237h", 2, 2, "", R"("velocity": true)", hasModes},
        {fraba, "37h", "0237h", 2, 2, wholePreset, R"("presets": true)", rearming},
        {fraba, "37h", "0237h", 2, 2, flag, noCapability, minusOne},
        {k4, "F7h", "03F7h", 2, 2},
        {rod, "33h", "0233h", 2, 2, rodDirection, R"("presetNeedsValue": true)"},
        {rod, "33h", "0233h", 2, 2,
         R"({"parameter": "error-status", "readOut": 8, "minimum": 0, "maximum": 65535})"},
        // 24 bit
        {rod, "33h", "0233h", 2, 2,
         R"({"parameter": "external-preset", "number": 4, "readOut": 4, "minimum": 0, "maximum": 16777215})"},
        {generic, "37h", "0237h", 2, 2,
         R"({"parameter": "steps", "number": 1, "minimum": 0, "maximum": 33554431})"},
    };
    for (const Parts &parts : sound) {
        Catalog catalog;
        const auto added = catalog.add(description(parts), QStringLiteral("some.json"));
        EXPECT_TRUE(added) << description(parts).toStdString() << added.error().reason.toStdString();
    }
}

TEST(DescriptionRules, TakeWhatTheCamsHaveWhereItIsTold)
{
    const auto camsIn = [](const char *capability) {
        Catalog catalog;
        EXPECT_TRUE(catalog.add(description({fraba, "37h", "0237h", 2, 2, "", capability, hasModes}), {}));
        return catalog.find(u"some")->capabilities.cams;
    };
    EXPECT_EQ(camsIn(R"("cams": false)"), std::nullopt);
    EXPECT_EQ(camsIn(R"("cams": true)"), CamAbilities());
    EXPECT_EQ(camsIn(R"("cams": {})"), CamAbilities());
    EXPECT_EQ(camsIn(R"("cams": {"programs": 4, "cams": 8, "cyclic": false, "mode": true, "shift": true,
                                 "hysteresis": false, "polarity": false})"),
              (CamAbilities{.programs = 4, .isCyclic = false}));
}

QByteArray onLine(const char *parameters, const char *capability = noCapability)
{
    return description({R"("ESC")", "", "", 0, 0, parameters, capability})
        .replace(R"( "idCode": "", "deviceCode": "", "inWords": 0, "outWords": 0,)", "");
}

// Kübler, ESC commands
TEST(DescriptionRules, TakeTheCommandsOfAnEncoderOnASerialLine)
{
    Catalog catalog;
    const auto added = catalog.add(
        onLine(R"({"parameter": "steps", "read": "D", "write": "GR", "minimum": 1, "maximum": 8192},
                  {"parameter": "direction", "read": "O", "bit": 0, "write": "GD", "minimum": 0, "maximum": 1},
                  {"parameter": "scaling", "read": "O", "bit": 2, "minimum": 0, "maximum": 1},
                  {"parameter": "address", "write": "X", "minimum": 1, "maximum": 31},
                  {"parameter": "serial-number", "read": "N", "minimum": 0, "maximum": 4294967295})"),
        QString());
    ASSERT_TRUE(added) << added.error().reason.toStdString();
    const DeviceDescription &device = *catalog.find(u"some");
    EXPECT_EQ(escReach(*device.find(Parameter::steps)), (EscReach{"D", {}, "GR"}));
    EXPECT_EQ(escReach(*device.find(Parameter::scaling)).bit, 2u);
    EXPECT_TRUE(device.find(Parameter::steps)->stored);
    EXPECT_FALSE(device.find(Parameter::scaling)->canBeWritten);
    EXPECT_TRUE(device.capabilities.reads && device.capabilities.writes && device.capabilities.serialNumber);
    EXPECT_EQ(device.readableValues().size(), 4u);
}

TEST(DescriptionRules, RefuseCommandsThatDoNotBelong)
{
    struct Row
    {
        QByteArray json;
        const char *key;
        const char *reason;
    };
    const Row rows[] = {
        {onLine(R"({"parameter": "steps", "read": "GR", "minimum": 1, "maximum": 2})"), "parameters[0].read",
         "\"GR\" is not a command that reads a value."},
        {onLine(R"({"parameter": "steps", "read": "V", "minimum": 1, "maximum": 2})"), "parameters[0].read",
         "\"V\" is not a command that reads a value."},
        {onLine(R"({"parameter": "steps", "read": "D", "write": "D", "minimum": 1, "maximum": 2})"),
         "parameters[0].write", "\"D\" is not a command that writes a value."},
        {onLine(R"({"parameter": "steps", "write": "GR", "minimum": 1, "maximum": 2})"),
         "parameters[0].write", "must be read, too"},
        {onLine(R"({"parameter": "steps", "number": 1, "minimum": 1, "maximum": 2})"), "parameters[0].number",
         "has the commands read and write"},
        {onLine(R"({"parameter": "steps", "read": "D", "write": "GR", "minimum": -1, "maximum": 2})"),
         "parameters[0].maximum", "between 1 and 8192"},
        {onLine(R"({"parameter": "direction", "read": "O", "bit": 0, "write": "GD",
                    "minimum": 0, "maximum": 16})"),
         "parameters[0].maximum", "between 0 and 1"},
        {onLine(R"({"parameter": "baud-rate", "write": "Y", "minimum": 4800, "maximum": 19200})"),
         "parameters[0].choices", "19200, 9600 or 4800"},
        {onLine(R"({"parameter": "baud-rate", "write": "Y", "minimum": 4800, "maximum": 19200,
                    "choices": [{"value": 5000, "key": "5000"}]})"),
         "parameters[0].choices", "19200, 9600 or 4800"},
        // GP would move the position, X the encoder to another address
        {onLine(R"({"parameter": "steps", "read": "D", "write": "GP", "minimum": 1, "maximum": 2})"),
         "parameters[0].write", "steps of the profile ESC has GR here."},
        {onLine(R"({"parameter": "offset", "read": "C", "write": "X", "minimum": 1, "maximum": 2})"),
         "parameters[0].write", "offset of the profile ESC has nothing here."},
        {onLine(R"({"parameter": "steps", "read": "U", "minimum": 1, "maximum": 2})"), "parameters[0].read",
         "steps of the profile ESC has D here."},
        {onLine(R"({"parameter": "direction", "read": "O", "minimum": 0, "maximum": 1})"),
         "parameters[0].bit", "direction of the profile ESC has 0 here."},
        {onLine(R"({"parameter": "steps", "read": "D", "bit": 0, "minimum": 1, "maximum": 2})"),
         "parameters[0].bit", "steps of the profile ESC has nothing here."},
        {onLine("", R"("presets": true, "presetNeedsValue": true)"), "capabilities.presets",
         "the range of the position"},
        {onLine(R"({"parameter": "preset", "read": "S", "minimum": 1, "maximum": 33554431})",
                R"("presets": true)"),
         "capabilities.presetNeedsValue", "Write true."},
        {onLine(R"({"parameter": "preset", "read": "S", "minimum": 1, "maximum": 4294967297})"),
         "parameters[0].maximum", "between 1 and 33554431"},
        {onLine(R"({"parameter": "steps", "read": "D", "minimum": 1, "maximum": 2},
                   {"parameter": "offset", "read": "D", "minimum": 1, "maximum": 2})"),
         "parameters[1].read", "is here twice"},
        {onLine(R"({"parameter": "address", "bit": 1, "write": "X", "minimum": 1, "maximum": 2})"),
         "parameters[0].bit", "there is none"},
        {onLine(R"({"parameter": "steps", "minimum": 1, "maximum": 2})"), "parameters[0].number",
         "on a serial line the commands read or write"},
        {description({generic, "37h", "0237h", 2, 2,
                      R"({"parameter": "steps", "number": 1, "read": "D", "minimum": 1, "maximum": 2})"}),
         "parameters[0].read", "Only an encoder on a serial line has commands."},
    };
    for (const Row &row : rows) {
        const auto added = Catalog().add(row.json, QStringLiteral("some.json"));
        if (added) {
            ADD_FAILURE() << row.reason << " is missed in " << row.json.toStdString();
            continue;
        }
        EXPECT_EQ(added.error().key.toStdString(), row.key) << added.error().reason.toStdString();
        EXPECT_TRUE(added.error().reason.contains(QLatin1String(row.reason)))
            << added.error().reason.toStdString();
    }
}

TEST(DescriptionRules, TakeTheCodingOfAnEncoderThatOnlyTellsItsPosition)
{
    Catalog catalog;
    ASSERT_TRUE(catalog.add(description({R"("K2", "coding": "signed")", "36h", "0236h", 2, 0}), QString()));
    EXPECT_EQ(catalog.find(u"some")->coding, PositionCoding::signedBinary);
}

struct Broken
{
    Parts parts;
    const char *key;
    const char *reason;
};

const Broken broken[] = {
    // ID codes
    {{k1, "37h", "0137h", 1, 0}, "idCode", "The ID code of the profile K1 is 36h or B2h."},
    {{k2, "B3h", "02B3h", 2, 0}, "idCode", "The ID code of the profile K2 is 36h or B2h."},
    {{generic, "36h", "0236h", 2, 2}, "idCode", "The ID code of the profile K3 is 37h or B3h."},
    {{k4, "37h", "0237h", 2, 2}, "idCode", "The ID code of the profile K4 is F7h."},
    {{rod, "37h", "0237h", 2, 2}, "idCode", "The ID code of the profile LA-66 is 33h."},
    // length codes
    {{k1, "36h", "0236h", 1, 0}, "deviceCode", "The device code of the profile K1 is 0136h or 01B2h."},
    {{k2, "B2h", "01B2h", 2, 0}, "deviceCode", "The device code of the profile K2 is 0236h or 02B2h."},
    {{fraba, "B3h", "01B3h", 2, 2}, "deviceCode", "The device code of the profile K3 is 0237h or 02B3h."},
    {{k4, "F7h", "02F7h", 2, 2}, "deviceCode", "The device code of the profile K4 is 03F7h."},
    {{rod, "33h", "0133h", 2, 2}, "deviceCode", "The device code of the profile LA-66 is 0233h."},
    // words
    {{k1, "36h", "0136h", 2, 0}, "inWords", "The words of the profile K1 are: IN 1, OUT 0."},
    {{k1, "36h", "0136h", 1, 1}, "outWords", "The words of the profile K1 are: IN 1, OUT 0."},
    {{k2, "36h", "0236h", 2, 2}, "outWords", "The words of the profile K2 are: IN 2, OUT 0."},
    {{generic, "37h", "0237h", 1, 2}, "inWords", "The words of the profile K3 are: IN 2, OUT 2."},
    {{generic, "37h", "0237h", 2, 0}, "outWords", "The words of the profile K3 are: IN 2, OUT 2."},
    {{k4, "F7h", "03F7h", 2, 0}, "outWords", "The words of the profile K4 are: IN 2, OUT 2."},
    {{rod, "33h", "0233h", 2, 1}, "outWords", "The words of the profile LA-66 are: IN 2, OUT 2."},
    // parameters
    {{k1, "36h", "0136h", 1, 0, writable}, "parameters[0].number", "profile K1 has no parameters"},
    {{k2, "36h", "0236h", 2, 0, readable}, "parameters[0].readOut", "profile K2 has no parameters"},
    {{k4, "F7h", "03F7h", 2, 2, writable}, "parameters[0].number", "profile K4 has no parameters"},
    {{rod, "33h", "0233h", 2, 2,
      R"({"parameter": "external-preset", "number": 4, "readOut": 4, "minimum": 0, "maximum": 16777216})"},
     "parameters[0].maximum",
     "between 0 and 16777215"},
    {{rod, "33h", "0233h", 2, 2,
      R"({"parameter": "external-preset", "number": 4, "readOut": 4, "minimum": -1, "maximum": 9})"},
     "parameters[0].minimum",
     "between 0 and 16777215"},
    {{generic, "37h", "0237h", 2, 2, R"({"parameter": "offset", "number": 7, "minimum": 0, "maximum": 9})"},
     "parameters[0].number",
     "number 7 sets all values to default"},
    // the words of a read-out
    {{baumer, "37h", "0237h", 2, 2, readable}, "parameters[0].readOut", "dialect fraba"},
    {{generic, "37h", "0237h", 2, 2, readable}, "parameters[0].readOut", "dialect fraba"},
    // the services of a rod: 6 would move the position
    {{rod, "33h", "0233h", 2, 2,
      R"({"parameter": "external-preset", "number": 6, "minimum": 0, "maximum": 9})"},
     "parameters[0].number",
     "external-preset of the profile LA-66 has 4 here."},
    {{rod, "33h", "0233h", 2, 2,
      R"({"parameter": "external-preset", "number": 4, "readOut": 2, "minimum": 0, "maximum": 9})"},
     "parameters[0].readOut",
     "external-preset of the profile LA-66 has 4 here."},
    {{rod, "33h", "0233h", 2, 2,
      R"({"parameter": "external-preset", "number": 4, "minimum": 0, "maximum": 9})"},
     "parameters[0].readOut",
     "is read back"},
    {{rod, "33h", "0233h", 2, 2,
      R"({"parameter": "error-status", "number": 8, "readOut": 8, "minimum": 0, "maximum": 9})"},
     "parameters[0].number",
     "error-status of the profile LA-66 has nothing here."},
    {{rod, "33h", "0233h", 2, 2, writable}, "parameters[0].number", "steps of the profile LA-66 has nothing"},
    {{rod, "33h", "0233h", 2, 2, R"({"parameter": "offset", "readOut": 5, "minimum": 0, "maximum": 9})"},
     "parameters[0].readOut",
     "offset of the profile LA-66 has nothing here."},
    // capabilities
    {{k1, "36h", "0136h", 1, 0, "", R"("presets": true)"}, "capabilities.presets", "profile K1 cannot do"},
    {{k2, "36h", "0236h", 2, 0, "", R"("cams": true)"}, "capabilities.cams", "profile K2 cannot do"},
    {{k4, "F7h", "03F7h", 2, 2, "", R"("velocity": true)"}, "capabilities.velocity", "profile K4 cannot do"},
    {{k4, "F7h", "03F7h", 2, 2, "", R"("resets": true)"}, "capabilities.resets", "profile K4 cannot do"},
    {{rod, "33h", "0233h", 2, 2, "", R"("cams": true)"}, "capabilities.cams", "profile LA-66 cannot do"},
    {{rod, "33h", "0233h", 2, 2, "", R"("resets": true)"}, "capabilities.resets", "profile LA-66 cannot do"},
    {{generic, "37h", "0237h", 2, 2, "", R"("cams": true)"}, "capabilities.cams", "dialect fraba"},
    {{baumer, "37h", "0237h", 2, 2, "", R"("velocity": true)"}, "capabilities.velocity", "dialect fraba"},
    {{baumer, "37h", "0237h", 2, 2, "", R"("manufacturerPreset": true)"},
     "capabilities.manufacturerPreset",
     "dialect fraba"},
    {{generic, "37h", "0237h", 2, 2, "", R"("presets": true)"},
     "capabilities.presets",
     "Give preset a number"},
    {{fraba, "37h", "0237h", 2, 2, presetReadOut, R"("presets": true)"},
     "capabilities.presets",
     "Give preset a number"},
    {{generic, "37h", "0237h", 2, 2, preset, R"("presetNeedsValue": true)"},
     "capabilities.presetNeedsValue",
     "profile K3 cannot do"},
    {{rod, "33h", "0233h", 2, 2, "", R"("presets": true)"}, "capabilities.presetNeedsValue", "Write true."},
    // quirks
    {{baumer, "37h", "0237h", 2, 2, "", noCapability, hasModes}, "quirks.hasModes", "dialect fraba"},
    {{k1, "36h", "0136h", 1, 0, "", noCapability, hasModes}, "quirks.hasModes", "profile K1 cannot do"},
    {{rod, "33h", "0233h", 2, 2, "", R"("cams": {"programs": 1})"},
     "capabilities.cams",
     "profile LA-66 cannot do"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": 8)", hasModes}, "capabilities.cams", "true or false"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"programs": 9})", hasModes},
     "capabilities.cams.programs",
     "9 is not between 1 and 8."},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"cams": 0})", hasModes},
     "capabilities.cams.cams",
     "0 is not between 1 and 8."},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"polarity": 1})", hasModes},
     "capabilities.cams.polarity",
     "true or false"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"inverted": true})", hasModes},
     "capabilities.cams.inverted",
     "not known"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"cams": 4})", hasModes},
     "capabilities.cams.cams",
     "words for 8 cams"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"shift": false})", hasModes},
     "capabilities.cams.shift",
     "beside a part of the position"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"mode": false})", hasModes},
     "capabilities.cams.mode",
     "a mode of their own"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"hysteresis": true})", hasModes},
     "capabilities.cams.hysteresis",
     "no word for the hysteresis"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": {"polarity": true})", hasModes},
     "capabilities.cams.polarity",
     "no word for the polarity"},
    {{fraba, "37h", "0237h", 2, 2, "", R"("cams": true)", noQuirk}, "quirks.hasModes", "Write true."},
    {{fraba, "37h", "0237h", 2, 2, "", R"("velocity": true)", noQuirk}, "quirks.hasModes", "Write true."},
    {{fraba, "37h", "0237h", 2, 2, "", noCapability, rearming},
     "quirks.presetNeedsRearming",
     "Give preset a number and a readOut"},
    {{fraba, "37h", "0237h", 2, 2, preset, R"("presets": true)", rearming},
     "quirks.presetNeedsRearming",
     "Give preset a number and a readOut"},
    {{fraba, "37h", "0237h", 2, 2, presetReadOut, noCapability, rearming},
     "quirks.presetNeedsRearming",
     "Give preset a number and a readOut"},
    {{baumer, "37h", "0237h", 2, 2, preset, noCapability, rearming},
     "quirks.presetNeedsRearming",
     "dialect fraba"},
    {{fraba, "37h", "0237h", 2, 2, readable, noCapability, minusOne},
     "quirks.mayCountStepsMinusOne",
     "multi-turn-steps-minus-1"},
    {{fraba, "37h", "0237h", 2, 2,
      R"({"parameter": "steps", "number": 1, "minimum": 0, "maximum": 9},
         {"parameter": "multi-turn-steps-minus-1", "readOut": 10, "minimum": 0, "maximum": 3})",
      noCapability, minusOne},
     "quirks.mayCountStepsMinusOne",
     "minimum of steps"},
    {{rod, "33h", "0233h", 2, 2, "", noCapability, minusOne},
     "quirks.mayCountStepsMinusOne",
     "profile LA-66 cannot do"},
};

TEST(DescriptionRules, RefuseWhatDoesNotBelongTogether)
{
    for (const Broken &each : broken) {
        const QByteArray json = description(each.parts);
        const auto added = Catalog().add(json, QStringLiteral("some.json"));
        if (added) {
            ADD_FAILURE() << each.reason << " is missed in " << json.toStdString();
            continue;
        }
        EXPECT_EQ(added.error().key.toStdString(), each.key) << json.toStdString();
        EXPECT_TRUE(added.error().reason.contains(QLatin1String(each.reason)))
            << added.error().reason.toStdString();
    }
}

} // namespace
} // namespace codewheel
