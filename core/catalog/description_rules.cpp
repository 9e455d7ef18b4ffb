// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/description_rules.h"

#include "catalog/data_field.h"
#include "catalog/hex_code.h"

#include <algorithm>

namespace codewheel {
namespace {

// The number of the word that sets a K3 to default (FRABA manual 5.3, Baumer manual 5).
constexpr unsigned resetNumber = 7;

struct PlaceOnBus
{
    Profile profile;
    int inWords;
    int outWords;
    std::vector<unsigned> deviceCodes; // length code << 8 | ID code; remote bus, then Loop 2
};

const PlaceOnBus *placeOf(Profile profile)
{
    static const std::vector<PlaceOnBus> places{
        {Profile::k1, 1, 0, {0x0136, 0x01B2}}, {Profile::k2, 2, 0, {0x0236, 0x02B2}},
        {Profile::k3, 2, 2, {0x0237, 0x02B3}}, {Profile::k4, 2, 2, {0x03F7}},
        {Profile::la66, 2, 2, {0x0233}},
    };
    const auto found = std::ranges::find(places, profile, &PlaceOnBus::profile);
    return found == places.end() ? nullptr : &*found;
}

bool hasParameters(Profile profile)
{
    return profile == Profile::k3 || profile == Profile::la66 || profile == Profile::esc;
}

class Rules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DescriptionRules)

public:
    static void checkCodes(const JsonObject &json, const DeviceDescription &device, const PlaceOnBus &place)
    {
        QStringList idCodes;
        QStringList deviceCodes;
        for (const unsigned code : place.deviceCodes) {
            idCodes << hexCode(code & 0xFF, 2);
            deviceCodes << hexCode(code, 4);
        }
        const QString profile = profileName(device.profile);
        if (!idCodes.contains(hexCode(device.idCode, 2)))
            json.report("idCode",
                        tr("The ID code of the profile %1 is %2.").arg(profile, idCodes.join(tr(" or "))));
        if (!deviceCodes.contains(hexCode(device.deviceCode, 4)))
            json.report(
                "deviceCode",
                tr("The device code of the profile %1 is %2.").arg(profile, deviceCodes.join(tr(" or "))));
    }

    static void checkWords(const JsonObject &json, const DeviceDescription &device, const PlaceOnBus &place)
    {
        const QString reason = tr("The words of the profile %1 are: IN %2, OUT %3.")
                                   .arg(profileName(device.profile))
                                   .arg(place.inWords)
                                   .arg(place.outWords);
        if (device.inWords != place.inWords)
            json.report("inWords", reason);
        if (device.outWords != place.outWords)
            json.report("outWords", reason);
    }

    static void checkRange(const JsonObject &row, const ParameterDescription &parameter, Profile profile)
    {
        if (!parameter.number)
            return;
        const QString reason =
            tr("A value that is written must be between 0 and %1: the word has no room for others.")
                .arg(largestData(profile));
        if (parameter.minimum < 0)
            row.report("minimum", reason);
        if (parameter.maximum > largestData(profile))
            row.report("maximum", reason);
    }

    // A device on a serial line has commands, all others have words.
    static void checkCommands(const JsonObject &row, const ParameterDescription &parameter)
    {
        for (const char *key : {"number", "readOut"})
            if (row.has(key))
                row.report(key,
                           tr("An encoder on a serial line has the commands read and write. Leave it out."));
        const bool isFoundAgain =
            parameter.parameter == Parameter::lineAddress || parameter.parameter == Parameter::baudRate;
        if (parameter.writeCommand && !parameter.readCommand && !isFoundAgain)
            row.report("write",
                       tr("What is written must be read, too: a write without an answer is checked."));
        const std::int64_t bound = largestData(Profile::esc);
        if (parameter.canBeWritten() && (parameter.minimum < 0 || parameter.maximum > bound))
            row.report("maximum", tr("A value that is written must be between 0 and %1.").arg(bound));
    }

    static void refuseCommands(const JsonObject &row)
    {
        for (const char *key : {"read", "write", "bit"})
            if (row.has(key))
                row.report(key, tr("Only an encoder on a serial line has commands. Leave it out."));
    }

    static void refuseParameters(const JsonObject &row, const ParameterDescription &parameter,
                                 Profile profile)
    {
        for (const char *key : {"number", "readOut"})
            if (row.has(key) && !parameter.onLabel)
                row.report(key, tr("An encoder of the profile %1 has no parameters that this program could "
                                   "write or read. Leave it out.")
                                    .arg(profileName(profile)));
    }

    static void refuse(const JsonObject &json, const char *key, bool value, Profile profile)
    {
        if (value)
            json.report(
                key,
                tr("An encoder of the profile %1 cannot do this. Write false.").arg(profileName(profile)));
    }

    // For what FRABA's words alone are known.
    static void refuseBesideFraba(const JsonObject &json, const char *key, bool value,
                                  const DeviceDescription &device)
    {
        refuse(json, key, value && device.profile != Profile::k3, device.profile);
        if (value && device.dialect != k3::Dialect::fraba)
            json.report(key, tr("Only with the dialect fraba are the words for it known. Write false."));
    }

    static void checkResets(const JsonObject &json, const DeviceDescription &device)
    {
        refuse(json, "resets", device.capabilities.resets && device.profile != Profile::k3, device.profile);
        if (device.capabilities.resets && device.findNumber(resetNumber))
            json.report("resets", tr("Parameter number %1 sets all values to default. It cannot be the "
                                     "number of a parameter, too.")
                                      .arg(resetNumber));
    }
};

} // namespace

void checkPlaceOnBus(const JsonObject &json, const DeviceDescription &device)
{
    if (const PlaceOnBus *place = placeOf(device.profile)) {
        Rules::checkCodes(json, device, *place);
        Rules::checkWords(json, device, *place);
    }
}

void checkParameter(const JsonObject &row, const ParameterDescription &parameter, Profile profile)
{
    if (profile == Profile::esc) {
        Rules::checkCommands(row, parameter);
        return;
    }
    Rules::refuseCommands(row);
    if (hasParameters(profile))
        Rules::checkRange(row, parameter, profile);
    else
        Rules::refuseParameters(row, parameter, profile);
}

void checkCapabilities(const JsonObject &json, const DeviceDescription &device)
{
    const Capabilities &can = device.capabilities;
    Rules::refuse(json, "presets", can.presets && !hasParameters(device.profile), device.profile);
    Rules::checkResets(json, device);
    Rules::refuseBesideFraba(json, "cams", can.cams, device);
    Rules::refuseBesideFraba(json, "velocity", can.velocity, device);
    Rules::refuseBesideFraba(json, "manufacturerPreset", can.manufacturerPreset, device);
}

void checkQuirks(const JsonObject &json, const DeviceDescription &device)
{
    Rules::refuseBesideFraba(json, "hasModes", device.quirks.hasModes, device);
}

} // namespace codewheel
