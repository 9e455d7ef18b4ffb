// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_rules.h"

#include "kinds/esc/protocol/esc_rules.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/la66_word.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct DescriptionRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DescriptionRules)
};

// Words have no letters, while the commands of a description are letters.
void refuseCommands(const JsonObject &row)
{
    for (const char *key : {"read", "write", "bit"})
        if (row.has(key))
            row.report(key,
                       DescriptionRules::tr("Only an encoder on a serial line has commands. Leave it out."));
}

// For encoders that receive values in words.
class WordRules : public ProtocolRules
{
public:
    bool hasParameters() const override { return true; }

    void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                        const DeviceDescription &device) const override
    {
        refuseCommands(row);
        checkRange(row, parameter);
        checkWords(row, parameter, device);
    }

private:
    virtual void checkWords(const JsonObject &row, const ParameterDescription &parameter,
                            const DeviceDescription &device) const = 0;

    void checkRange(const JsonObject &row, const ParameterDescription &parameter) const
    {
        if (!parameter.number)
            return;
        const QString reason =
            DescriptionRules::tr(
                "A value that is written must be between 0 and %1: the word has no room for others.")
                .arg(largestData());
        if (parameter.minimum < 0)
            row.report("minimum", reason);
        if (parameter.maximum > largestData())
            row.report("maximum", reason);
    }
};

class K3Rules final : public WordRules
{
public:
    std::int64_t largestData() const override { return k3::dataMask; } // D24..D0 (ENCOM profile 71)

    void checkPresets(const JsonObject &json, const DeviceDescription &device) const override
    {
        const ParameterDescription *preset = device.find(Parameter::preset);
        if (!preset || !preset->number)
            json.report("presets",
                        DescriptionRules::tr("The word that sets the position takes the parameter preset. "
                                             "Give preset a number, or write false."));
    }

private:
    // The number of the word that sets a K3 to default (FRABA manual 5.3, Baumer manual 5).
    static constexpr unsigned resetNumber = 7;

    // The word 2021000n is known only of FRABA, and 0E000000 does not write a value.
    void checkWords(const JsonObject &row, const ParameterDescription &parameter,
                    const DeviceDescription &device) const override
    {
        if (parameter.number == resetNumber)
            row.report("number", DescriptionRules::tr(
                                     "Parameter number %1 sets all values to default. It cannot be the "
                                     "number of a parameter, too.")
                                     .arg(resetNumber));
        if (parameter.readOut && device.dialect != k3::Dialect::fraba)
            row.report("readOut",
                       DescriptionRules::tr(
                           "Only with the dialect fraba are the words of a read-out known. Leave it out."));
    }
};

class La66Rules final : public WordRules
{
public:
    bool presetsByCommand() const override { return true; }
    std::int64_t largestData() const override { return la66::dataMask; } // D23..D0

private:
    // The services that write and read a parameter (LA-66 manual 3).
    struct Services
    {
        Parameter parameter;
        std::optional<unsigned> write;
        std::optional<unsigned> read;
    };
    static constexpr std::array services{
        Services{Parameter::direction, la66::countingDirection, la66::countingDirection},
        Services{Parameter::measuringLength, la66::measuringLength, la66::measuringLength},
        Services{Parameter::externalPreset, la66::externalPreset, la66::externalPreset},
        Services{Parameter::errorStatus, {}, la66::errorStatus},
    };

    // What is not read, or not written, may be left out.
    void checkWords(const JsonObject &row, const ParameterDescription &parameter,
                    const DeviceDescription & /*device*/) const override
    {
        const auto found = std::ranges::find(services, parameter.parameter, &Services::parameter);
        const Services known = found == services.end() ? Services{parameter.parameter, {}, {}} : *found;
        const auto text = [](std::optional<unsigned> number) {
            return number ? QString::number(*number) : QString();
        };
        if (parameter.number)
            checkPlace(row, "number", text(parameter.number), text(known.write), parameter, Profile::la66);
        if (parameter.readOut)
            checkPlace(row, "readOut", text(parameter.readOut), text(known.read), parameter, Profile::la66);
        if (parameter.number && !parameter.readOut)
            row.report("readOut",
                       DescriptionRules::tr("What is written must be read, too: it is read back."));
    }
};

} // namespace

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

const ProtocolRules &protocolRules(Profile profile)
{
    static const ProtocolRules withoutParameters;
    static const K3Rules k3;
    static const La66Rules la66;
    switch (profile) {
    case Profile::k3:
        return k3;
    case Profile::la66:
        return la66;
    case Profile::esc:
        return escRules();
    case Profile::k1:
    case Profile::k2:
    case Profile::k4:
        break;
    }
    return withoutParameters;
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
