// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_rules.h"

#include "catalog/rule_texts.h"

namespace codewheel {

void WordRules::checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                               const DeviceDescription &device) const
{
    refuseCommands(row);
    checkRange(row, parameter);
    checkWords(row, parameter, device);
}

void WordRules::checkRange(const JsonObject &row, const ParameterDescription &parameter) const
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

} // namespace codewheel
