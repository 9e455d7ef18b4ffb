// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/rule_texts.h"
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/profiles.h"
#include "kinds/interbus/words/word_reach.h"
#include "kinds/interbus/words/word_rules.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

class La66Rules final : public WordRules
{
public:
    La66Rules()
        : WordRules({.deviceCodes = {0x0233}})
    {}

    const WordMeanings *wordMeanings() const override { return &la66Meanings(); }
    bool hasOneCoding(const DeviceDescription & /*device*/) const override { return true; }
    bool measuresLength(const DeviceDescription & /*device*/) const override { return true; }
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
        const WordReach reach = wordReach(parameter);
        if (reach.number)
            checkPlace(row, "number", text(reach.number), text(known.write), parameter, profile::la66);
        if (reach.readOut)
            checkPlace(row, "readOut", text(reach.readOut), text(known.read), parameter, profile::la66);
        if (reach.number && !reach.readOut)
            row.report("readOut",
                       DescriptionRules::tr("What is written must be read, too: it is read back."));
    }
};

} // namespace

const ProtocolRules &la66Rules()
{
    static const La66Rules rules;
    return rules;
}

} // namespace codewheel
