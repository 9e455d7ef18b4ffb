// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/rule_texts.h"
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/word_reach.h"
#include "kinds/interbus/words/word_rules.h"

namespace codewheel {
namespace {

constexpr NamedValue<k3::Dialect> dialects[] = {
    {"generic", k3::Dialect::generic}, {"fraba", k3::Dialect::fraba}, {"baumer", k3::Dialect::baumer}};

class K3Rules final : public WordRules
{
public:
    K3Rules()
        : WordRules({.deviceCodes = {0x0237, 0x02B3}})
    {}

    const WordMeanings *wordMeanings() const override { return &k3Meanings(); }
    int positionBits(const DeviceDescription & /*device*/) const override { return k3::dataBits; }
    bool activatesByRun() const override { return true; }
    // A parameter number must not come twice in a parameterization (Baumer manual 5).
    bool restoresBehindRun(const DeviceDescription &device) const override
    {
        return device.dialect != k3::Dialect::fraba;
    }
    bool hasOneCoding(const DeviceDescription &device) const override
    {
        return device.dialect == k3::Dialect::fraba;
    }
    bool dependsOnMake() const override { return true; }
    std::int64_t largestData() const override { return k3::dataMask; } // D24..D0 (ENCOM profile 71)

    void readDialect(const JsonObject &json, DeviceDescription &device) const override
    {
        device.dialect = json.oneOf("dialect", dialects);
        if (device.dialect != k3::Dialect::generic && !json.has("vendor"))
            json.report("vendor",
                        DescriptionRules::tr("Only a description of the generic dialect has no vendor."));
    }

    // By parameters 1 to 4 and run (error 3; FRABA manual 5.3, Baumer manual 6).
    void complete(ParameterDescription &parameter) const override
    {
        constexpr unsigned lastOfThem = 4;
        parameter.isNeededAfterLoss = wordReach(parameter).number.value_or(lastOfThem + 1) <= lastOfThem;
    }

    void checkPresets(const JsonObject &json, const DeviceDescription &device) const override
    {
        const ParameterDescription *preset = device.find(Parameter::preset);
        if (!preset || !preset->canBeWritten)
            json.report("presets",
                        DescriptionRules::tr("The word that sets the position takes the parameter preset. "
                                             "Give preset a number, or write false."));
    }

    void checkAbilities(const JsonObject &json, const DeviceDescription &device) const override
    {
        const Capabilities &can = device.capabilities;
        if (can.cams)
            checkCams(json, device);
        refuseBesideFraba(json, "velocity", can.velocity, device);
        refuseBesideFraba(json, "manufacturerPreset", can.manufacturerPreset, device);
    }

    void checkQuirks(const JsonObject &json, const DeviceDescription &device) const override
    {
        const Quirks &quirks = device.quirks;
        refuseBesideFraba(json, "presetNeedsRearming", quirks.presetNeedsRearming, device);
        checkRearming(json, device);
        refuseBesideFraba(json, "mayCountStepsMinusOne", quirks.mayCountStepsMinusOne, device);
        checkStepsMinusOne(json, device);
        refuseBesideFraba(json, "hasModes", quirks.hasModes, device);
        checkModes(json, device);
    }

private:
    // For what is known only of FRABA's words.
    static void refuseBesideFraba(const JsonObject &json, const char *key, bool isClaimed,
                                  const DeviceDescription &device)
    {
        if (isClaimed && device.dialect != k3::Dialect::fraba)
            json.report(key, DescriptionRules::tr(
                                 "Only with the dialect fraba are the words for it known. Write false."));
    }
    static void checkCams(const JsonObject &json, const DeviceDescription &device);
    static void checkRearming(const JsonObject &json, const DeviceDescription &device);
    static void checkStepsMinusOne(const JsonObject &json, const DeviceDescription &device);
    static void checkModes(const JsonObject &json, const DeviceDescription &device);

    // The number of the word that sets a K3 to default (FRABA manual 5.3, Baumer manual 5).
    static constexpr unsigned resetNumber = 7;

    // The word 2021000n is known only of FRABA, and 0E000000 does not write a value.
    void checkWords(const JsonObject &row, const ParameterDescription &parameter,
                    const DeviceDescription &device) const override
    {
        if (wordReach(parameter).number == resetNumber)
            row.report("number", DescriptionRules::tr(
                                     "Parameter number %1 sets all values to default. It cannot be the "
                                     "number of a parameter, too.")
                                     .arg(resetNumber));
        if (parameter.canBeRead && device.dialect != k3::Dialect::fraba)
            row.report("readOut",
                       DescriptionRules::tr(
                           "Only with the dialect fraba are the words of a read-out known. Leave it out."));
    }
};

// What its words can express of cams (FRABA manual 5.4.4).
void K3Rules::checkCams(const JsonObject &json, const DeviceDescription &device)
{
    const auto &cams = device.capabilities.cams;
    refuseBesideFraba(json, "cams", cams.has_value(), device);
    if (!json.hasObject("cams"))
        return;
    const JsonObject told = json.objectOfAny("cams");
    if (cams->cams != k3::camCount)
        told.report(
            "cams",
            DescriptionRules::tr("A K3 has words for %1 cams in each program. Write %1.").arg(k3::camCount));
    if (!cams->hasMode)
        told.report("mode", DescriptionRules::tr("A K3 shows its cams in a mode of their own. Write true."));
    if (!cams->hasShift)
        told.report("shift",
                    DescriptionRules::tr("A K3 shows its cams beside a part of the position. Write true."));
    if (cams->hasHysteresis)
        told.report("hysteresis",
                    DescriptionRules::tr("A K3 has no word for the hysteresis of a cam. Write false."));
    if (cams->hasPolarity)
        told.report("polarity",
                    DescriptionRules::tr("A K3 has no word for the polarity of a cam. Write false."));
}
void K3Rules::checkRearming(const JsonObject &json, const DeviceDescription &device)
{
    const ParameterDescription *preset = device.find(Parameter::preset);
    if (device.quirks.presetNeedsRearming && (!preset || !preset->canBeWritten || !preset->canBeRead))
        json.report("presetNeedsRearming",
                    DescriptionRules::tr(
                        "The preset is read, and programmed again. Give preset a number and a readOut, or "
                        "write false."));
}
void K3Rules::checkStepsMinusOne(const JsonObject &json, const DeviceDescription &device)
{
    if (!device.quirks.mayCountStepsMinusOne)
        return;
    const ParameterDescription *flag = device.find(Parameter::multiTurnAndStepsMinusOne);
    if (!flag || !flag->canBeRead)
        json.report("mayCountStepsMinusOne",
                    DescriptionRules::tr(
                        "The parameter multi-turn-steps-minus-1 tells which of both the encoder does. Give "
                        "it a readOut, or write false."));
    const ParameterDescription *steps = device.find(Parameter::steps);
    if (steps && steps->canBeWritten && steps->minimum < 1)
        json.report("mayCountStepsMinusOne",
                    DescriptionRules::tr("An encoder that is sent steps - 1 cannot be sent 0 "
                                         "steps. Let the minimum of steps be 1 or more."));
}
// Where modes exist, the encoder is asked which one it is in before a word is sent that depends on it.
void K3Rules::checkModes(const JsonObject &json, const DeviceDescription &device)
{
    const Capabilities &can = device.capabilities;
    if (!device.quirks.hasModes && (can.cams || can.velocity))
        json.report("hasModes", DescriptionRules::tr(
                                    "Cams and velocity are modes beside position mode, in which words mean "
                                    "something else. Write true."));
}
} // namespace

const ProtocolRules &k3Rules()
{
    static const K3Rules rules;
    return rules;
}

} // namespace codewheel
