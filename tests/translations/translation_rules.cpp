// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/translations/translation_rules.h"

#include <QRegularExpression>

namespace codewheel {
namespace {

const QRegularExpression placePattern(QStringLiteral("%(?:n|L?[1-9])"));
const QRegularExpression mnemonicPattern(QStringLiteral("&[^&\\s]"));
const QRegularExpression wordPattern(QStringLiteral("\\p{L}"));

// "%1", "%n": each once, in order
QStringList placesIn(const QString &text)
{
    QStringList places;
    for (auto match = placePattern.globalMatch(text); match.hasNext();)
        places << match.next().captured();
    places.sort();
    places.removeDuplicates();
    return places;
}

bool hasWords(QString text)
{
    return text.remove(placePattern).contains(wordPattern);
}

// A space at the start or end is where two texts are joined.
bool sameEnds(const QString &a, const QString &b)
{
    return a.startsWith(u' ') == b.startsWith(u' ') && a.endsWith(u' ') == b.endsWith(u' ');
}

} // namespace

QStringList faultsOf(const TsText &text, const QStringList &sameInBoth)
{
    QStringList faults;
    if (!text.isFinished)
        faults << QStringLiteral("is not finished");
    if (text.translations.size() != (text.hasNumber ? 2 : 1))
        faults << QStringLiteral("has %1 forms").arg(text.translations.size());
    for (const QString &translation : text.translations) {
        if (translation.trimmed().isEmpty())
            faults << QStringLiteral("is empty");
        else if (translation == text.source && hasWords(text.source) && !sameInBoth.contains(text.source))
            faults << QStringLiteral("is still English");
        if (placesIn(translation) != placesIn(text.source))
            faults << QStringLiteral("has other placeholders: ") + translation;
        if (translation.contains(mnemonicPattern) != text.source.contains(mnemonicPattern))
            faults << QStringLiteral("has a key (&) in one language only: ") + translation;
        if (!sameEnds(translation, text.source))
            faults << QStringLiteral("begins or ends with a space in one language only: ") + translation;
    }
    return faults;
}

} // namespace codewheel
