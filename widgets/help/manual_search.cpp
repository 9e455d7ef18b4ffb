// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manual_search.h"

#include "widgets/help/manual.h"

#include <QRegularExpression>

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype lettersBefore = 30; // of the excerpt
constexpr qsizetype lettersOfExcerpt = 110;

bool hasEach(const QString &text, const QStringList &words)
{
    return std::ranges::all_of(words,
                               [&](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool hasOne(const QString &text, const QStringList &words)
{
    return std::ranges::any_of(words,
                               [&](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

QString excerptOf(const QString &text, const QStringList &words)
{
    qsizetype first = text.size();
    for (const QString &word : words)
        if (const auto at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0)
            first = std::min(first, at);
    if (first == text.size())
        first = 0;
    qsizetype begin = std::max<qsizetype>(0, first - lettersBefore);
    if (begin > 0) // at a word
        begin = std::min(first, text.indexOf(QRegularExpression(QStringLiteral("\\s")), begin) + 1);
    const QString cut = text.mid(begin, lettersOfExcerpt).simplified();
    const QString dots(QChar(0x2026));
    return (begin > 0 ? dots : QString()) + cut + (begin + lettersOfExcerpt < text.size() ? dots : QString());
}

} // namespace

QStringList searchedWords(const QString &typed)
{
    static const QRegularExpression word(QStringLiteral("\"([^\"]+)\"?|([^\\s\"]+)"));
    QStringList words;
    for (auto each = word.globalMatch(typed); each.hasNext();) {
        const auto match = each.next();
        const QString text = (match.captured(1) + match.captured(2)).simplified();
        if (!text.isEmpty())
            words << text;
    }
    words.removeDuplicates();
    return words;
}

std::vector<ManualHit> searchManual(const Manual &manual, const QStringList &words)
{
    if (words.isEmpty())
        return {};
    std::vector<ManualHit> hits;
    std::vector<ManualHit> inText;
    for (const ManualPage &page : manual.pages())
        for (const ManualSection &section : page.sections) {
            const QString heading = page.title + u' ' + section.title;
            if (!hasEach(heading + u'\n' + section.text, words) ||
                !hasOne(section.title + u'\n' + section.text, words))
                continue;
            QUrl url = page.url;
            url.setFragment(section.anchor);
            auto &its = hasOne(section.title, words) ? hits : inText;
            its.push_back({url, page.title, section.title, excerptOf(section.text, words)});
        }
    hits.insert(hits.end(), inText.begin(), inText.end());
    return hits;
}

} // namespace codewheel
