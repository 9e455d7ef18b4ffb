// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/explain_word.h"

#include "catalog/protocol_rules.h"
#include "catalog/word_meanings.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

const WordMeanings *meaningsOf(const DeviceDescription &device)
{
    return protocolRules(device.profile).wordMeanings();
}

QString joined(const QStringList &texts)
{
    return texts.join(QCoreApplication::translate("Meaning", ", or: "));
}

} // namespace

Explanation explainWord(const DeviceDescription &device, Word word, const WordContext &context)
{
    if (const WordMeanings *meanings = meaningsOf(device))
        return meanings->explain(device, word, context);
    return Meaning{context.direction == WordDirection::out ? MeaningId::undefinedOut : MeaningId::undefinedIn,
                   {word}};
}

QString explanationText(const DeviceDescription &device, const Explanation &explanation)
{
    const WordMeanings *meanings = meaningsOf(device);
    QStringList texts;
    for (const Meaning &meaning : explanation)
        texts << meaningSentence(meaning.id,
                                 meanings != nullptr ? meanings->parts(device, meaning) : QStringList());
    return isOfOperation(explanation)
               ? QCoreApplication::translate("Meaning", "Running, %1").arg(joined(texts))
               : joined(texts);
}

QString bitText(const DeviceDescription &device, WordDirection direction, int bit)
{
    constexpr int bits = 32;
    const WordMeanings *meanings = meaningsOf(device);
    return meanings != nullptr && bit >= 0 && bit < bits ? meanings->bitText(device, direction, bit)
                                                         : QString();
}

} // namespace codewheel
