// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/explain_word.h"

#include "catalog/meaning_parts.h"
#include "catalog/position_format.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/la66_explain.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// A request for a value, as it applies to this device: it may have no such parameter, or not accept the
// value. The words alone do not tell.
Meaning forDevice(const DeviceDescription &device, Meaning meaning)
{
    const auto number = static_cast<unsigned>(meaning.number[0]);
    if (meaning.id == MeaningId::parameterRequest) {
        if (!hasNumber(device, number))
            meaning.id = MeaningId::parameterRequestUndefined;
        else if (!takesValue(device, number, meaning.number[1]))
            meaning.id = MeaningId::parameterRequestInvalid;
    } else if (meaning.id == MeaningId::serviceWrite && !takesValue(device, number, meaning.number[1])) {
        meaning.id = MeaningId::serviceWriteInvalid;
    }
    return meaning;
}

Explanation forDevice(const DeviceDescription &device, const Explanation &explanation)
{
    Explanation possible;
    for (const Meaning &meaning : explanation)
        possible.add(forDevice(device, meaning));
    return possible;
}

QString joined(const QStringList &texts)
{
    return texts.join(QCoreApplication::translate("Meaning", ", or: "));
}

} // namespace

Explanation explainWord(const DeviceDescription &device, Word word, k3::ExplainContext context)
{
    if (device.profile == Profile::la66)
        return forDevice(device, la66::explain(word, context.direction, context.counterpart));
    if (onlyTellsPosition(device.profile))
        return position_word::explain(word, context.direction, positionFormat(device));
    context.dialect = device.dialect;
    if (!device.mayHaveModes())
        context.mode = Mode::position;
    // A FRABA has a single coding; with a Baumer it is a parameter.
    if (device.dialect == k3::Dialect::fraba && !context.coding)
        context.coding = PositionCoding::binary;
    return forDevice(device, k3::explain(word, context));
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
