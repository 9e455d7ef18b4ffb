// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/palette/folded_text.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr QChar sharpS(0x00DF);

// The letter below an accent.
QChar baseOf(QChar letter)
{
    const QString parts = letter.decomposition();
    return parts.isEmpty() || letter.decompositionTag() != QChar::Canonical ? letter : parts.front();
}

bool takesUmlaut(QChar letter)
{
    return letter == u'a' || letter == u'o' || letter == u'u';
}

// Calls add(letter, index of it in the text).
template <class Add>
void fold(const QString &text, Add add)
{
    bool mayBeUmlaut = false;
    for (int i = 0; i < text.size(); ++i) {
        QChar letter = text[i];
        if (letter.unicode() >= 0x80) {
            if (letter.isMark())
                continue;
            letter = baseOf(letter);
        }
        letter = letter.toLower();
        if (letter == u'e' && std::exchange(mayBeUmlaut, false))
            continue;
        mayBeUmlaut = takesUmlaut(letter);
        add(letter == sharpS ? QChar(u's') : letter, i);
        if (letter == sharpS)
            add(QChar(u's'), i);
    }
}

} // namespace

QString foldedText(const QString &text)
{
    QString folded;
    folded.reserve(text.size());
    fold(text, [&](QChar letter, int) { folded += letter; });
    return folded;
}

QStringList foldedWords(const QString &typed)
{
    return foldedText(typed.simplified()).split(u' ', Qt::SkipEmptyParts);
}

std::vector<std::pair<int, int>> marksOf(const QString &text, const QStringList &words)
{
    QString folded;
    std::vector<int> from;
    fold(text, [&](QChar letter, int index) {
        folded += letter;
        from.push_back(index);
    });
    from.push_back(static_cast<int>(text.size()));
    std::vector<bool> isMarked(static_cast<std::size_t>(text.size()), false);
    for (const QString &word : words)
        for (auto at = folded.indexOf(word); at >= 0; at = folded.indexOf(word, at + word.size()))
            std::fill(isMarked.begin() + from[static_cast<std::size_t>(at)],
                      isMarked.begin() + from[static_cast<std::size_t>(at + word.size())], true);
    std::vector<std::pair<int, int>> marks;
    for (int i = 0; i < text.size(); ++i) {
        if (!isMarked[static_cast<std::size_t>(i)])
            continue;
        if (marks.empty() || marks.back().first + marks.back().second != i)
            marks.emplace_back(i, 0);
        ++marks.back().second;
    }
    return marks;
}

} // namespace codewheel
