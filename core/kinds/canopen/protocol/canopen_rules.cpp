// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_rules.h"
#include "kinds/canopen/canopen_protocols.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/encoder_bits.h"
#include "vocabulary/hex.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using canopen::ObjectType;
using canopen::SdoObject;

// The object that a parameter that everybody knows is (CiA 406), if it is one of the profile.
struct ObjectRow
{
    Parameter parameter;
    std::uint16_t index;
    std::optional<unsigned> bit{};
    std::optional<unsigned> linearBit{};
};

constexpr std::array objectRows{
    ObjectRow{Parameter::steps, 0x6001},           ObjectRow{Parameter::measuringRange, 0x6002},
    ObjectRow{Parameter::measuringLength, 0x6002}, ObjectRow{Parameter::direction, 0x6000, 0, 3},
    ObjectRow{Parameter::scaling, 0x6000, 2, 2},   ObjectRow{Parameter::preset, 0x6003},
    ObjectRow{Parameter::offset, 0x6509},          ObjectRow{Parameter::lowerLimit, 0x6401},
    ObjectRow{Parameter::upperLimit, 0x6402},      ObjectRow{Parameter::operatingParameters, 0x6500},
    ObjectRow{Parameter::alarms, 0x6503},          ObjectRow{Parameter::warnings, 0x6505},
    ObjectRow{Parameter::operatingTime, 0x6508},   ObjectRow{Parameter::deviceCode, 0x1000},
};

std::optional<SdoObject> objectOf(const QString &text)
{
    const qsizetype colon = text.indexOf(u':');
    bool isIndex = false;
    bool isSub = colon < 0;
    constexpr int hexadecimal = 16;
    constexpr uint largestSub = 0xFF;
    const ushort index = text.left(colon).toUShort(&isIndex, hexadecimal);
    const uint sub = colon < 0 ? 0 : text.sliced(colon + 1).toUInt(&isSub);
    if (!isIndex || !isSub || index == 0 || sub > largestSub)
        return std::nullopt;
    return SdoObject{index, static_cast<std::uint8_t>(sub)};
}

constexpr NamedValue<ObjectType> objectTypes[] = {
    {"u8", ObjectType::u8},   {"u16", ObjectType::u16}, {"u32", ObjectType::u32},  {"i8", ObjectType::i8},
    {"i16", ObjectType::i16}, {"i32", ObjectType::i32}, {"text", ObjectType::text}};

struct Access
{
    bool canBeRead;
    bool canBeWritten;
};
enum class AccessName : std::uint8_t { readOnly, readAndWrite, writeOnly };
constexpr NamedValue<AccessName> accessNames[] = {
    {"ro", AccessName::readOnly}, {"rw", AccessName::readAndWrite}, {"wo", AccessName::writeOnly}};
constexpr std::array accesses{Access{true, false}, Access{true, true}, Access{false, true}};

class CanopenRules final : public ProtocolRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenRules)

public:
    bool hasParameters() const override { return true; }
    bool hasObjects() const override { return true; }
    bool hasTexts() const override { return true; }
    bool storesByStep() const override { return true; }
    bool presetsByCommand() const override { return true; }
    bool hasOneCoding(const DeviceDescription & /*device*/) const override { return true; }
    bool measuresLength(const DeviceDescription &device) const override
    {
        return canopenDevice(device).isLinear;
    }
    int positionBits(const DeviceDescription & /*device*/) const override { return 32; }
    std::int64_t smallestData() const override { return -0x8000'0000LL; }
    std::int64_t largestData() const override { return 0xFFFF'FFFFLL; }

    void readDialect(const JsonObject &json, DeviceDescription &device) const override;
    void readReach(const JsonObject &row, ParameterDescription &parameter,
                   const DeviceDescription &before) const override;
    void complete(ParameterDescription &parameter) const override;
    ReachText reachText(const ParameterDescription &parameter) const override;
    void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                        const DeviceDescription &device) const override;
    void checkPresets(const JsonObject &json, const DeviceDescription &device) const override;
    void checkAbilities(const JsonObject &json, const DeviceDescription &device) const override;

private:
    static void readRates(const JsonObject &json, CanopenDevice &its);
    static void checkObject(const JsonObject &row, const ParameterDescription &parameter,
                            const DeviceDescription &device, const CanopenReach &reach);
    static void checkWritten(const JsonObject &row, const DeviceDescription &device,
                             const CanopenReach &reach);
};

void CanopenRules::readDialect(const JsonObject &json, DeviceDescription &device) const
{
    constexpr NamedValue<bool> dialects[] = {{"rotary", false}, {"linear", true}};
    CanopenDevice its;
    its.isLinear = json.has("dialect") && json.oneOf("dialect", dialects);
    const auto numberOf = [&json](const char *key) {
        return json.has(key) ? std::optional(json.hexNumber(key)) : std::nullopt;
    };
    its.vendor = numberOf("vendorNumber");
    its.product = numberOf("productNumber");
    its.revision = numberOf("revisionNumber");
    if (json.has("nodeNumberObject")) {
        its.nodeNumber = objectOf(json.text("nodeNumberObject"));
        if (!its.vendor || !its.nodeNumber || !isMakers(*its.nodeNumber))
            json.report("nodeNumberObject", tr("The object of the node number is one of the maker (2000h to "
                                               "5FFFh), and the vendorNumber says whose."));
    }
    readRates(json, its);
    device.ofKind = KindData(its);
}

// The numbers of an object are the maker's own; where LSS has others than CiA 305, the maker is known too.
void CanopenRules::readRates(const JsonObject &json, CanopenDevice &its)
{
    constexpr std::int64_t largestNumber = 0xFF;
    constexpr std::int64_t highestRate = 1'000'000;
    if (json.has("rateObject")) {
        its.rateObject = objectOf(json.text("rateObject"));
        if (!its.vendor || !its.rateObject || !isMakers(*its.rateObject) || !json.has("rates"))
            json.report("rateObject", tr("The object of the rate is one of the maker (2000h to 5FFFh), the "
                                         "vendorNumber says whose, and rates what its numbers stand for."));
    }
    if (!json.has("rates"))
        return;
    if (!its.vendor)
        json.report("rates",
                    tr("Which rates have other numbers depends on the make: give the description the "
                       "vendorNumber of the device (1018h:1)."));
    for (const JsonObject &row : json.array("rates", {"number", "rate"})) {
        const NumberedRate one{.rate = static_cast<int>(row.number("rate", 1, highestRate)),
                               .number = static_cast<int>(row.number("number", 0, largestNumber))};
        const auto isTaken = [&](const NumberedRate &other) {
            return other.rate == one.rate || other.number == one.number;
        };
        if (std::ranges::any_of(its.rates, isTaken))
            row.report("rate", tr("This rate or its number is here twice."));
        its.rates.push_back(one);
    }
}

void CanopenRules::readReach(const JsonObject &row, ParameterDescription &parameter,
                             const DeviceDescription &before) const
{
    if (!row.has("object"))
        return;
    constexpr std::int64_t highestBit = 31;
    const auto object = objectOf(row.text("object"));
    if (!object)
        row.report("object", tr("An object is written as index and, unless 0, subindex: \"6001\", "
                                "\"1018:4\"."));
    const auto bit = row.optionalNumber("bit", 0, highestBit);
    const CanopenReach reach{.object = object.value_or(SdoObject()),
                             .type = row.oneOf("type", objectTypes),
                             .bit = bit ? std::optional(static_cast<unsigned>(*bit)) : std::nullopt};
    const Access access = accesses.at(static_cast<std::size_t>(
        row.has("access") ? row.oneOf("access", accessNames) : AccessName::readOnly));
    parameter.canBeRead = access.canBeRead;
    parameter.canBeWritten = access.canBeWritten;
    parameter.reach = KindData(reach);
    if (std::ranges::any_of(before.parameters, [&](const ParameterDescription &other) {
            const CanopenReach *its = canopenReach(other);
            return its != nullptr && its->object == reach.object && its->bit == reach.bit;
        }))
        row.report("object", tr("This object is here twice."));
}

void CanopenRules::complete(ParameterDescription &parameter) const
{
    const CanopenReach *reach = canopenReach(parameter);
    if (reach != nullptr && !reach->bit)
        parameter.form = canopen::encoderValueForm(reach->object.index);
}

ProtocolRules::ReachText CanopenRules::reachText(const ParameterDescription &parameter) const
{
    const CanopenReach *reach = canopenReach(parameter);
    if (reach == nullptr)
        return {};
    const QString text =
        reach->bit ? tr("%1, bit %2").arg(reach->object.text()).arg(*reach->bit) : reach->object.text();
    return {.write = parameter.canBeWritten ? text : QString(),
            .read = parameter.canBeRead ? text : QString()};
}

void CanopenRules::checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                                  const DeviceDescription &device) const
{
    for (const char *key : {"number", "readOut", "read", "write"})
        if (row.has(key))
            row.report(key, tr("An encoder on CANopen has objects. Leave it out."));
    const CanopenReach *reach = canopenReach(parameter);
    if (reach == nullptr)
        return;
    if (parameter.isText() != (reach->type == ObjectType::text))
        row.report("type", tr("A parameter with text has the type text, and no other has."));
    checkObject(row, parameter, device, *reach);
    if (parameter.canBeWritten)
        checkWritten(row, device, *reach);
}

// Of the profile, by what everybody knows the parameter as: a maker may have it elsewhere.
void CanopenRules::checkObject(const JsonObject &row, const ParameterDescription &parameter,
                               const DeviceDescription &device, const CanopenReach &reach)
{
    const auto known = std::ranges::find(objectRows, parameter.parameter, &ObjectRow::parameter);
    if (known == objectRows.end() || isMakers(reach.object))
        return;
    const bool isLinear = canopenDevice(device).isLinear;
    const auto indexText = [](std::uint16_t index) { return hexNumber(index, 4); };
    const auto bitText = [](std::optional<unsigned> bit) { return bit ? QString::number(*bit) : QString(); };
    checkPlace(row, "object", indexText(reach.object.index), indexText(known->index), parameter,
               device.profile);
    checkPlace(row, "bit", bitText(reach.bit), bitText(isLinear ? known->linearBit : known->bit), parameter,
               device.profile);
}

void CanopenRules::checkWritten(const JsonObject &row, const DeviceDescription &device,
                                const CanopenReach &reach)
{
    if (isNoValue(reach.object))
        row.report("access", tr("Writing this object does more than giving a value. Write ro."));
    if (isMakers(reach.object) && !canopenDevice(device).vendor)
        row.report("access", tr("What an object of the maker means depends on the make: give the "
                                "description the vendorNumber of the device (1018h:1), or write ro."));
}

void CanopenRules::checkPresets(const JsonObject &json, const DeviceDescription &device) const
{
    const ParameterDescription *preset = device.find(Parameter::preset);
    if (preset == nullptr || !preset->canBeRead)
        json.report("presets", tr("The parameter preset tells the range of the position. Give preset the "
                                  "object 6003, or write false."));
}

void CanopenRules::checkAbilities(const JsonObject &json, const DeviceDescription &device) const
{
    const Capabilities &can = device.capabilities;
    refuseAbility(json, "velocity", can.velocity, device.profile);
    refuseAbility(json, "manufacturerPreset", can.manufacturerPreset, device.profile);
    const bool hasOwnCams = can.cams && (can.cams->programs > 1 || can.cams->hasMode || can.cams->hasShift);
    if (hasOwnCams)
        json.report("cams", tr("The cams of CiA 406 are one program, without a mode and without a shift: "
                               "write {\"programs\": 1, \"mode\": false, \"shift\": false}."));
}

} // namespace

const ProtocolRules &canopenRules()
{
    static const CanopenRules rules;
    return rules;
}

} // namespace codewheel
