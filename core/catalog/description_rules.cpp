// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/description_reader.h"
#include "catalog/protocol_rules.h"
#include "catalog/rule_texts.h"

namespace codewheel {
namespace {

// Where the new position comes from: with a K3 from the parameter, otherwise from the command itself.
void checkPresets(const JsonObject &json, const DeviceDescription &device)
{
    const ProtocolRules &rules = protocolRules(device.profile);
    const bool presets = device.capabilities.presets;
    const bool needsValue = device.capabilities.presetNeedsValue;
    refuseAbility(json, "presets", presets && !rules.hasParameters(), device.profile);
    refuseAbility(json, "presetNeedsValue", needsValue && !rules.presetsByCommand(), device.profile);
    if (presets)
        rules.checkPresets(json, device);
    if (presets && rules.presetsByCommand() && !needsValue)
        json.report(
            "presetNeedsValue",
            DescriptionRules::tr("The encoder gets the position together with the command that sets it. "
                                 "Write true."));
}

} // namespace

void checkCapabilities(const JsonObject &json, const DeviceDescription &device)
{
    checkPresets(json, device);
    protocolRules(device.profile).checkAbilities(json, device);
}

} // namespace codewheel
