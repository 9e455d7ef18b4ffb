// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_rules.h"

#include "catalog/rule_texts.h"

namespace codewheel {

void ProtocolRules::checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                                   const DeviceDescription &device) const
{
    refuseCommands(row);
    for (const char *key : {"number", "readOut"})
        if (row.has(key) && !parameter.onLabel)
            row.report(key, DescriptionRules::tr("An encoder of the profile %1 has no parameters that this "
                                                 "program could write or read. Leave it out.")
                                .arg(profileName(device.profile)));
}

void ProtocolRules::readDialect(const JsonObject &json, DeviceDescription & /*device*/) const
{
    if (json.has("dialect"))
        json.report("dialect", DescriptionRules::tr("Only a K3 has a dialect. Leave it out."));
}

void ProtocolRules::readPlaceOnBus(const JsonObject &json, DeviceDescription &device) const
{
    for (const char *key : {"idCode", "deviceCode", "inWords", "outWords"})
        if (json.has(key))
            json.report(key,
                        hasObjects()
                            ? DescriptionRules::tr("Only an encoder on INTERBUS has one. Leave it out.")
                            : DescriptionRules::tr("An encoder on a serial line has none. Leave it out."));
    device.inWords = device.outWords = 0;
}

void ProtocolRules::checkAbilities(const JsonObject &json, const DeviceDescription &device) const
{
    const Capabilities &can = device.capabilities;
    refuseAbility(json, "resets", can.resets, device.profile);
    refuseAbility(json, "cams", can.cams.has_value(), device.profile);
    refuseAbility(json, "velocity", can.velocity, device.profile);
    refuseAbility(json, "manufacturerPreset", can.manufacturerPreset, device.profile);
}

void ProtocolRules::checkQuirks(const JsonObject &json, const DeviceDescription &device) const
{
    const Quirks &quirks = device.quirks;
    refuseAbility(json, "presetNeedsRearming", quirks.presetNeedsRearming, device.profile);
    refuseAbility(json, "mayCountStepsMinusOne", quirks.mayCountStepsMinusOne, device.profile);
    refuseAbility(json, "hasModes", quirks.hasModes, device.profile);
}

void refuseAbility(const JsonObject &json, const char *key, bool isClaimed, Profile profile)
{
    if (isClaimed)
        json.report(key, DescriptionRules::tr("An encoder of the profile %1 cannot do this. Write false.")
                             .arg(profileName(profile)));
}

void refuseCommands(const JsonObject &row)
{
    for (const char *key : {"read", "write", "bit"})
        if (row.has(key))
            row.report(key,
                       DescriptionRules::tr("Only an encoder on a serial line has commands. Leave it out."));
}

void checkPlace(const JsonObject &row, const char *key, const QString &given, const QString &known,
                const ParameterDescription &parameter, Profile profile)
{
    if (given == known)
        return;
    const QString owner =
        DescriptionRules::tr("%1 of the profile %2", "a parameter, as subject of a sentence")
            .arg(parameterKey(parameter.parameter), profileName(profile));
    row.report(key,
               known.isEmpty()
                   ? DescriptionRules::tr(
                         "%1 has nothing here. Leave it out: the encoder would do or show something else.")
                         .arg(owner)
                   : DescriptionRules::tr(
                         "%1 has %2 here. Anything else makes the encoder do or show something else.")
                         .arg(owner, known));
}

} // namespace codewheel
