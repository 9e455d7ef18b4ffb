// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_rules.h"

#include "catalog/rule_texts.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/word_rules.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

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

} // namespace

const ProtocolRules &k3Rules()
{
    static const K3Rules rules;
    return rules;
}

} // namespace codewheel
