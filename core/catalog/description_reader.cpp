// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/description_reader.h"

#include "catalog/protocol_rules.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr NamedValue<PositionCoding> codings[] = {{"binary", PositionCoding::binary},
                                                  {"signed", PositionCoding::signedBinary},
                                                  {"gray", PositionCoding::gray}};
constexpr NamedValue<Unit> units[] = {{"none", Unit::none},
                                      {"steps", Unit::steps},
                                      {"revolutions", Unit::revolutions},
                                      {"ten-minutes", Unit::tenMinutes},
                                      {"tenth-degree-celsius", Unit::tenthDegreeCelsius},
                                      {"micrometres", Unit::micrometres},
                                      {"tenth-hours", Unit::tenthHours},
                                      {"milliseconds", Unit::milliseconds}};
constexpr NamedValue<RefusalId> errorMeanings[] = {
    {"wrongParameterData", RefusalId::wrongParameterData},
    {"unknownParameterNumber", RefusalId::unknownParameterNumber},
    {"parametersLost", RefusalId::parametersLost},
    {"eepromStoreError", RefusalId::eepromStoreError},
    {"batteryLow", RefusalId::batteryLow},
    {"codeDiscFault", RefusalId::codeDiscFault},
    {"manufacturerError", RefusalId::manufacturerError},
    {"magnetOutOfRange", RefusalId::magnetOutOfRange},
    {"otherDeviceError", RefusalId::otherDeviceError},
};

constexpr std::int64_t highestNumber = 15; // of an error, D28..D25
constexpr std::int64_t mostHexDigits = 8;
constexpr int longestText = 255;
constexpr std::int64_t mostStepsPerTurn = 1 << 25;
constexpr std::int64_t mostTurns = 1 << 25;
constexpr std::int64_t mostWrites = 1'000'000'000;

bool isCommon(Parameter parameter)
{
    const std::vector<Parameter> common = commonParameters();
    return std::ranges::find(common, parameter) != common.end();
}

// The rules of a description, part by part. One object per file.
class DescriptionReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DescriptionReader)

public:
    static void readCoding(const JsonObject &json, DeviceDescription &device);
    static void readIdentity(const JsonObject &json, DeviceDescription &device);
    static void readTables(const JsonObject &json, const Catalog &catalog, DeviceDescription &device);
    static void readParameters(const JsonObject &json, DeviceDescription &device);
    static void readErrors(const JsonObject &json, DeviceDescription &device);
    static CamAbilities readCams(const JsonObject &json);
    static Capabilities readCapabilities(const JsonObject &json);
    static Quirks readQuirks(const JsonObject &json);

private:
    static Parameter readParameterName(const JsonObject &row, const LocalText &shown);
    static ParameterDescription readParameter(const JsonObject &row, const DeviceDescription &device);
    static void readChoices(const JsonObject &row, ParameterDescription &parameter);
    static void checkRange(const JsonObject &row, const ParameterDescription &parameter);
    static void refuseTaken(const JsonObject &row, const ParameterDescription &parameter,
                            const DeviceDescription &device);
    static void refuseObjects(const JsonObject &row, const ProtocolRules &rules);
};

bool isKey(QStringView text)
{
    return !text.isEmpty() && std::ranges::all_of(text, [](QChar c) {
        return (c >= u'a' && c <= u'z') || (c >= u'0' && c <= u'9') || c == u'-';
    });
}

// Also as dictionaries of objects number theirs: "2000:1".
bool isParameterKey(QStringView text)
{
    return isKey(text.toString().removeIf([](QChar c) { return c == u':' || c == u'.'; }));
}

void DescriptionReader::readCoding(const JsonObject &json, DeviceDescription &device)
{
    if (!json.has("coding"))
        return;
    device.coding = json.oneOf("coding", codings);
    if (!protocolRules(device.profile).hasFixedCoding())
        json.report("coding", tr("Only a K1 and a K2 always have the same coding. Leave it out."));
}

Profile readProfile(const JsonObject &json)
{
    const QString name = json.text("profile");
    QStringList names;
    for (const Profile profile : allProfiles()) {
        names << profileName(profile);
        if (names.last() == name)
            return profile;
    }
    json.reportUnknownName("profile", name, names);
    return {};
}

void DescriptionReader::readIdentity(const JsonObject &json, DeviceDescription &device)
{
    device.key = json.text("key");
    if (!isKey(device.key))
        json.report("key", tr("A key consists of the letters a to z, digits and hyphens."));
    device.name = json.text("name");
    device.manual = json.text("manual");
    device.notes = json.localTextOr("notes", {});
    device.profile = readProfile(json);
    const ProtocolRules &rules = protocolRules(device.profile);
    rules.readDialect(json, device);
    device.vendor = json.textOr("vendor", {});
    rules.readPlaceOnBus(json, device);
    for (const char *key :
         {"vendorNumber", "productNumber", "revisionNumber", "nodeNumberObject", "rateObject", "rates"})
        if (json.has(key) && !rules.hasObjects())
            json.report(key, tr("Only an encoder on CANopen has one. Leave it out."));
    device.physicalStepsPerTurn = static_cast<int>(json.number("physicalStepsPerTurn", 0, mostStepsPerTurn));
    device.physicalTurns = static_cast<int>(json.number("physicalTurns", 0, mostTurns));
    readCoding(json, device);
}

Parameter DescriptionReader::readParameterName(const JsonObject &row, const LocalText &shown)
{
    const QString name = row.text("parameter");
    if (row.has("name")) {
        if (!isParameterKey(name))
            row.report("parameter",
                       tr("A parameter is named by small letters, digits, hyphens, colons and full "
                          "stops."));
        return Parameter::of(name, shown);
    }
    QStringList known;
    for (const Parameter each : commonParameters()) {
        known << parameterKey(each);
        if (known.last() == name)
            return each;
    }
    row.reportUnknownName("parameter", name, known);
    return Parameter::steps;
}

void DescriptionReader::readChoices(const JsonObject &row, ParameterDescription &parameter)
{
    if (!row.has("choices"))
        return;
    for (const JsonObject &json : row.array("choices", {"value", "key"})) {
        const Choice choice{json.number("value", parameter.minimum, parameter.maximum), json.text("key")};
        if (!isKey(choice.key))
            json.report("key", tr("A key consists of the letters a to z, digits and hyphens."));
        if (parameter.findChoice(choice.value))
            json.report("value", tr("This value is here twice."));
        if (parameter.findChoice(choice.key))
            json.report("key", tr("This key is here twice."));
        parameter.choices.push_back(choice);
    }
}

void DescriptionReader::checkRange(const JsonObject &row, const ParameterDescription &parameter)
{
    if (parameter.minimum > parameter.maximum)
        row.report("minimum", tr("The minimum is larger than the maximum."));
    if (!parameter.factory)
        return;
    if (*parameter.factory < parameter.minimum || *parameter.factory > parameter.maximum)
        row.report("factory", tr("The factory setting is not between minimum and maximum."));
    if (!parameter.choices.empty() && !parameter.findChoice(*parameter.factory))
        row.report("factory", tr("The factory setting is none of the choices."));
}

ParameterDescription DescriptionReader::readParameter(const JsonObject &row, const DeviceDescription &device)
{
    ParameterDescription parameter;
    const LocalText name = row.localTextOr("name", {});
    parameter.parameter = readParameterName(row, name);
    if (!isCommon(parameter.parameter)) // the program names those
        parameter.name = name;
    protocolRules(device.profile).readReach(row, parameter, device);
    parameter.onLabel = row.flagOr("onLabel", false);
    const bool isOnWire = parameter.canBeRead || parameter.canBeWritten;
    if (parameter.onLabel && isOnWire)
        row.report("onLabel", tr("What only the label tells can be neither written nor read."));
    const auto isTold = [&row](const char *key) { return row.has(key); };
    const bool tellsReach =
        std::ranges::any_of(ProtocolRules::reachKeys, isTold); // what is wrong with it was said
    if (!isOnWire && !parameter.onLabel && !tellsReach)
        row.report("number", tr("A parameter needs a number to write it, a readOut code to read it, both, or "
                                "onLabel; on a serial line the commands read or write."));
    parameter.textLength = row.numberOr("text", 0, 1, longestText);
    if (parameter.isText() && !protocolRules(device.profile).hasTexts())
        row.report("text", tr("An encoder of the profile %1 has only numbers. Leave it out.")
                               .arg(profileName(device.profile)));
    if (!parameter.isText()) {
        parameter.minimum = row.number("minimum");
        parameter.maximum = row.number("maximum");
        parameter.factory = row.optionalNumber("factory");
    }
    parameter.unit = row.has("unit") ? row.oneOf("unit", units) : Unit::none;
    parameter.stored = row.flagOr("stored", parameter.canBeWritten);
    parameter.chapter = row.localTextOr("chapter", {});
    parameter.isDetail = row.flagOr("detail", false);
    parameter.hexDigits = static_cast<int>(row.numberOr("hexDigits", 0, 0, mostHexDigits));
    if (parameter.minimum <= parameter.maximum)
        readChoices(row, parameter);
    checkRange(row, parameter);
    return parameter;
}

void DescriptionReader::refuseTaken(const JsonObject &row, const ParameterDescription &parameter,
                                    const DeviceDescription &device)
{
    if (device.find(parameter.parameter))
        row.report("parameter", tr("This parameter is here twice."));
}

void DescriptionReader::refuseObjects(const JsonObject &row, const ProtocolRules &rules)
{
    for (const char *key : ProtocolRules::objectKeys)
        if (row.has(key) && !rules.hasObjects())
            row.report(key, tr("Only an encoder on CANopen has objects. Leave it out."));
}

void DescriptionReader::readParameters(const JsonObject &json, DeviceDescription &device)
{
    for (const JsonObject &row : json.array(
             "parameters", {"parameter", "name",    "detail", "hexDigits", "number",  "readOut", "minimum",
                            "maximum",   "factory", "unit",   "stored",    "onLabel", "choices", "chapter",
                            "read",      "write",   "bit",    "text",      "object",  "type",    "access"})) {
        const ProtocolRules &rules = protocolRules(device.profile);
        refuseObjects(row, rules);
        ParameterDescription parameter = readParameter(row, device);
        refuseTaken(row, parameter, device);
        rules.checkParameter(row, parameter, device);
        rules.complete(parameter);
        device.parameters.push_back(parameter);
    }
}

void DescriptionReader::readErrors(const JsonObject &json, DeviceDescription &device)
{
    for (const JsonObject &row : json.array("errors", {"number", "meaning", "warning", "text"})) {
        const DeviceError error{static_cast<unsigned>(row.number("number", 1, highestNumber)),
                                row.oneOf("meaning", errorMeanings), row.flagOr("warning", false),
                                row.localTextOr("text", {})};
        if (device.findError(error.number))
            row.report("number", tr("This number is here twice."));
        device.errors.push_back(error);
    }
}

std::optional<int> readWrites(const JsonObject &json, const char *key)
{
    const auto writes = json.optionalNumber(key, 1, mostWrites);
    return writes ? std::optional(static_cast<int>(*writes)) : std::nullopt;
}

// What is not given is as with the cams of a K3.
CamAbilities DescriptionReader::readCams(const JsonObject &json)
{
    CamAbilities cams;
    cams.programs = static_cast<unsigned>(json.numberOr("programs", static_cast<int>(cams.programs), 1,
                                                        static_cast<int>(CamProgram::programs)));
    cams.cams = static_cast<std::size_t>(
        json.numberOr("cams", static_cast<int>(cams.cams), 1, static_cast<int>(CamProgram::cams)));
    cams.isCyclic = json.flagOr("cyclic", cams.isCyclic);
    cams.hasMode = json.flagOr("mode", cams.hasMode);
    cams.hasShift = json.flagOr("shift", cams.hasShift);
    cams.hasHysteresis = json.flagOr("hysteresis", cams.hasHysteresis);
    cams.hasPolarity = json.flagOr("polarity", cams.hasPolarity);
    return cams;
}

Capabilities DescriptionReader::readCapabilities(const JsonObject &json)
{
    Capabilities can;
    can.presets = json.flag("presets");
    if (json.hasObject("cams"))
        can.cams = readCams(
            json.object("cams", {"programs", "cams", "cyclic", "mode", "shift", "hysteresis", "polarity"}));
    else if (json.flag("cams"))
        can.cams.emplace();
    can.readingHidesPosition = json.flag("readingHidesPosition");
    can.presetIsStored = json.flag("presetIsStored");
    can.hasBattery = json.flag("hasBattery");
    can.velocity = json.flagOr("velocity", false);
    can.manufacturerPreset = json.flagOr("manufacturerPreset", false);
    can.resets = json.flagOr("resets", false);
    can.presetNeedsValue = json.flagOr("presetNeedsValue", false);
    can.eepromBudget = readWrites(json, "eepromBudget");
    can.eepromLimit = readWrites(json, "eepromLimit");
    if (can.eepromBudget && can.eepromLimit && *can.eepromBudget > *can.eepromLimit)
        json.report("eepromBudget", tr("The budget is larger than eepromLimit."));
    return can;
}

Quirks DescriptionReader::readQuirks(const JsonObject &json)
{
    Quirks quirks;
    quirks.confirmsWhileProcessing = json.flag("confirmsWhileProcessing");
    quirks.presetNeedsRearming = json.flag("presetNeedsRearming");
    quirks.mayCountStepsMinusOne = json.flag("mayCountStepsMinusOne");
    quirks.hasModes = json.flag("hasModes");
    return quirks;
}

// A table of its own takes precedence over that of the description it shares tables with.
void DescriptionReader::readTables(const JsonObject &json, const Catalog &catalog, DeviceDescription &device)
{
    const DeviceDescription none;
    const DeviceDescription *shared = &none;
    if (json.has("tablesOf")) {
        const QString key = json.text("tablesOf");
        if (const DeviceDescription *found = catalog.find(key))
            shared = found;
        else
            json.report("tablesOf", tr("There is no device with the key \"%1\" before this one.").arg(key));
    }
    device.connectors = json.has("connectors") ? readConnectors(json) : shared->connectors;
    device.leds = json.has("leds") ? readLeds(json) : shared->leds;
    device.supply = json.has("supply") ? readSupply(json) : shared->supply;
    device.limits = json.has("limits") ? readLimits(json) : shared->limits;
    device.orderingKey = json.has("orderingKey") ? readOrderingKey(json) : shared->orderingKey;
}

// What follows from the parameters need not be given a second time.
void completeCapabilities(DeviceDescription &device)
{
    const auto readable = [](const ParameterDescription &p) { return p.canBeRead; };
    const auto writable = [](const ParameterDescription &p) { return p.canBeWritten; };
    const ParameterDescription *serialNumber = device.find(Parameter::serialNumber);
    device.capabilities.reads = std::ranges::any_of(device.parameters, readable);
    device.capabilities.writes = std::ranges::any_of(device.parameters, writable);
    device.capabilities.serialNumber = serialNumber && serialNumber->canBeRead;
}

} // namespace

DeviceDescription readDescription(const Json::Value &root, const Catalog &catalog, FaultKeeper &faults)
{
    const JsonObject json(root, QString(),
                          {"key",           "vendor",        "name",           "manual",
                           "notes",         "profile",       "dialect",        "idCode",
                           "deviceCode",    "inWords",       "outWords",       "physicalStepsPerTurn",
                           "physicalTurns", "coding",        "parameters",     "errors",
                           "capabilities",  "quirks",        "tablesOf",       "connectors",
                           "leds",          "supply",        "limits",         "orderingKey",
                           "vendorNumber",  "productNumber", "revisionNumber", "nodeNumberObject",
                           "rateObject",    "rates"},
                          faults);
    DeviceDescription device;
    DescriptionReader::readIdentity(json, device);
    DescriptionReader::readParameters(json, device);
    DescriptionReader::readErrors(json, device);
    const JsonObject capabilities =
        json.object("capabilities",
                    {"presets", "cams", "readingHidesPosition", "presetIsStored", "hasBattery", "velocity",
                     "manufacturerPreset", "resets", "presetNeedsValue", "eepromBudget", "eepromLimit"});
    device.capabilities = DescriptionReader::readCapabilities(capabilities);
    checkCapabilities(capabilities, device);
    const JsonObject quirks = json.object(
        "quirks", {"confirmsWhileProcessing", "presetNeedsRearming", "mayCountStepsMinusOne", "hasModes"});
    device.quirks = DescriptionReader::readQuirks(quirks);
    protocolRules(device.profile).checkQuirks(quirks, device);
    DescriptionReader::readTables(json, catalog, device);
    completeCapabilities(device);
    return device;
}

} // namespace codewheel
