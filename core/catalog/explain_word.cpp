// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/explain_word.h"

#include "catalog/meaning_parts.h"
#include "catalog/position_format.h"
#include "words/la66_explain.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

QString joined(const QStringList &texts)
{
    return texts.join(QCoreApplication::translate("Meaning", ", or: "));
}

} // namespace

Explanation explainWord(const DeviceDescription &device, Word word, k3::ExplainContext context)
{
    if (device.profile == Profile::la66)
        return la66::explain(word, context.direction, context.counterpart);
    if (onlyTellsPosition(device.profile))
        return position_word::explain(word, context.direction, positionFormat(device));
    context.dialect = device.dialect;
    if (!device.mayHaveModes())
        context.mode = Mode::position;
    // A FRABA has one coding; at a Baumer it is a parameter.
    if (device.dialect == k3::Dialect::fraba && !context.coding)
        context.coding = PositionCoding::binary;
    return k3::explain(word, context);
}

QString explanationText(const DeviceDescription &device, const Explanation &explanation)
{
    QStringList texts;
    for (const Meaning &meaning : explanation)
        texts << meaningSentence(meaning.id, meaningParts(device, meaning));
    const bool running =
        std::ranges::all_of(explanation, [](const Meaning &meaning) { return isOfOperation(meaning.id); });
    return running ? QCoreApplication::translate("Meaning", "Running, %1").arg(joined(texts)) : joined(texts);
}

} // namespace codewheel
