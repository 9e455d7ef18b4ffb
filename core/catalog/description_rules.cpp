// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/description_rules.h"

#include "catalog/hex_code.h"
#include "catalog/protocol_rules.h"
#include "kinds/interbus/words/k3_cam_word.h"

#include <algorithm>

namespace codewheel {
namespace {

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

    static void refuse(const JsonObject &json, const char *key, bool value, Profile profile)
    {
        if (value)
            json.report(
                key,
                tr("An encoder of the profile %1 cannot do this. Write false.").arg(profileName(profile)));
    }

    // For what is known only of FRABA's words.
    static void refuseBesideFraba(const JsonObject &json, const char *key, bool value,
                                  const DeviceDescription &device)
    {
        refuse(json, key, value && device.profile != Profile::k3, device.profile);
        if (value && device.dialect != k3::Dialect::fraba)
            json.report(key, tr("Only with the dialect fraba are the words for it known. Write false."));
    }

    // What the words of a K3, so far the only kind with cams, can express of them (FRABA manual 5.4.4).
    static void checkCams(const JsonObject &json, const DeviceDescription &device)
    {
        const auto &cams = device.capabilities.cams;
        refuseBesideFraba(json, "cams", cams.has_value(), device);
        if (!json.hasObject("cams"))
            return;
        const JsonObject told = json.objectOfAny("cams");
        if (cams->cams != k3::camCount)
            told.report("cams",
                        tr("A K3 has words for %1 cams in each program. Write %1.").arg(k3::camCount));
        if (!cams->hasMode)
            told.report("mode", tr("A K3 shows its cams in a mode of their own. Write true."));
        if (!cams->hasShift)
            told.report("shift", tr("A K3 shows its cams beside a part of the position. Write true."));
        if (cams->hasHysteresis)
            told.report("hysteresis", tr("A K3 has no word for the hysteresis of a cam. Write false."));
        if (cams->hasPolarity)
            told.report("polarity", tr("A K3 has no word for the polarity of a cam. Write false."));
    }

    // Where the new position comes from: with a K3 from the parameter, otherwise from the command itself.
    static void checkPresets(const JsonObject &json, const DeviceDescription &device)
    {
        const ProtocolRules &rules = protocolRules(device.profile);
        const bool presets = device.capabilities.presets;
        const bool needsValue = device.capabilities.presetNeedsValue;
        refuse(json, "presets", presets && !rules.hasParameters(), device.profile);
        refuse(json, "presetNeedsValue", needsValue && !rules.presetsByCommand(), device.profile);
        if (presets)
            rules.checkPresets(json, device);
        if (presets && rules.presetsByCommand() && !needsValue)
            json.report(
                "presetNeedsValue",
                tr("The encoder gets the position together with the command that sets it. Write true."));
    }

    static void checkRearming(const JsonObject &json, const DeviceDescription &device)
    {
        const ParameterDescription *preset = device.find(Parameter::preset);
        if (device.quirks.presetNeedsRearming && (!preset || !preset->number || !preset->readOut))
            json.report("presetNeedsRearming",
                        tr("The preset is read, and programmed again. Give preset a number and a readOut, or "
                           "write false."));
    }

    static void checkStepsMinusOne(const JsonObject &json, const DeviceDescription &device)
    {
        if (!device.quirks.mayCountStepsMinusOne)
            return;
        const ParameterDescription *flag = device.find(Parameter::multiTurnAndStepsMinusOne);
        if (!flag || !flag->readOut)
            json.report(
                "mayCountStepsMinusOne",
                tr("The parameter multi-turn-steps-minus-1 tells which of both the encoder does. Give "
                   "it a readOut, or write false."));
        const ParameterDescription *steps = device.find(Parameter::steps);
        if (steps && steps->number && steps->minimum < 1)
            json.report("mayCountStepsMinusOne", tr("An encoder that is sent steps - 1 cannot be sent 0 "
                                                    "steps. Let the minimum of steps be 1 or more."));
    }

    // Where modes exist, the encoder is asked which one it is in before a word is sent that depends on it.
    static void checkModes(const JsonObject &json, const DeviceDescription &device)
    {
        const Capabilities &can = device.capabilities;
        if (!device.quirks.hasModes && (can.cams || can.velocity))
            json.report("hasModes",
                        tr("Cams and velocity are modes beside position mode, in which words mean "
                           "something else. Write true."));
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

void checkCapabilities(const JsonObject &json, const DeviceDescription &device)
{
    const Capabilities &can = device.capabilities;
    Rules::checkPresets(json, device);
    Rules::refuse(json, "resets", can.resets && device.profile != Profile::k3, device.profile);
    Rules::checkCams(json, device);
    Rules::refuseBesideFraba(json, "velocity", can.velocity, device);
    Rules::refuseBesideFraba(json, "manufacturerPreset", can.manufacturerPreset, device);
}

void checkQuirks(const JsonObject &json, const DeviceDescription &device)
{
    const Quirks &quirks = device.quirks;
    Rules::refuseBesideFraba(json, "presetNeedsRearming", quirks.presetNeedsRearming, device);
    Rules::checkRearming(json, device);
    Rules::refuseBesideFraba(json, "mayCountStepsMinusOne", quirks.mayCountStepsMinusOne, device);
    Rules::checkStepsMinusOne(json, device);
    Rules::refuseBesideFraba(json, "hasModes", quirks.hasModes, device);
    Rules::checkModes(json, device);
}

} // namespace codewheel
