// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/palette/palette_index.h"

#include "widgets/palette/folded_text.h"
#include "widgets/palette/palette_kind.h"

#include <algorithm>
#include <tuple>

namespace codewheel {
namespace {

// How far from what one means, by where a word is.
enum Distance { titleBegin, wordOfTitle, wordElsewhere, withinTitle, withinElsewhere };

constexpr int ofWhatIsOff = wordElsewhere; // further away

bool isMessage(const PaletteEntry &entry)
{
    return entry.kind == PaletteEntry::Kind::message;
}

// What one does or looks at comes before what one reads about it.
bool isManual(const PaletteEntry &entry)
{
    return entry.kind == PaletteEntry::Kind::manual;
}

bool isOff(const PaletteEntry &entry)
{
    return entry.state && !entry.state().isEnabled;
}

bool beginsWord(const QString &text, qsizetype at)
{
    return at == 0 || !text[at - 1].isLetterOrNumber();
}

} // namespace

void PaletteIndex::clear()
{
    *this = {};
}

void PaletteIndex::add(std::vector<PaletteEntry> entries)
{
    for (PaletteEntry &entry : entries) {
        const QString title = foldedText(entry.title);
        const QStringList rest{title,
                               foldedText(kindWord(entry.kind)),
                               foldedText(entry.context),
                               foldedText(entry.key),
                               foldedText(entry.does),
                               foldedText(entry.words)};
        m_folded.push_back({rest.join(u'\n'), title.size(), foldedText(entry.key)});
        m_entries.push_back(std::move(entry));
    }
}

int PaletteIndex::distanceOf(const QString &word, const Folded &folded)
{
    int best = -1;
    for (auto at = folded.text.indexOf(word); at >= 0; at = folded.text.indexOf(word, at + 1)) {
        const bool isOfTitle = at < folded.title;
        const bool isBegin = beginsWord(folded.text, at);
        const int distance = at == 0     ? titleBegin
                             : isOfTitle ? (isBegin ? wordOfTitle : withinTitle)
                                         : (isBegin ? wordElsewhere : withinElsewhere);
        best = best < 0 ? distance : std::min(best, distance);
        if (best <= wordOfTitle || (best == wordElsewhere && !isOfTitle))
            break; // nothing better follows
    }
    return best;
}

void PaletteIndex::keepIfFound(std::size_t entry, const QStringList &words, std::vector<Hit> &hits) const
{
    const Folded &folded = m_folded[entry];
    Hit hit{entry, 0, isMessage(m_entries[entry]) ? 0 : folded.title};
    for (const QString &word : words) {
        const int distance = distanceOf(word, folded);
        if (distance < 0)
            return;
        hit.distance += distance;
    }
    hits.push_back(hit);
}

std::vector<std::size_t> PaletteIndex::find(const QString &typed)
{
    const QStringList words = foldedWords(typed);
    const QString folded = words.join(u' ');
    const bool isTypedOn = !m_typed.isEmpty() && folded.startsWith(m_typed);
    std::vector<Hit> hits;
    if (isTypedOn)
        for (const Hit &before : m_hits)
            keepIfFound(before.entry, words, hits);
    for (std::size_t i = isTypedOn ? m_searched : 0; i < m_entries.size(); ++i)
        keepIfFound(i, words, hits);
    m_typed = folded;
    m_searched = m_entries.size();
    m_hits = hits;

    for (Hit &hit : hits) {
        hit.isOff = isOff(m_entries[hit.entry]);
        hit.distance += hit.isOff ? ofWhatIsOff : 0;
    }
    std::ranges::sort(hits, {}, [this, &folded](const Hit &hit) {
        const PaletteEntry &entry = m_entries[hit.entry];
        const bool hasKey = m_folded[hit.entry].key == folded;
        return std::tuple(isMessage(entry), !hasKey, hit.distance, hit.isOff, isManual(entry), hit.length,
                          hit.entry);
    });
    std::vector<std::size_t> found;
    found.reserve(hits.size());
    std::ranges::transform(hits, std::back_inserter(found), &Hit::entry);
    return found;
}

std::vector<std::size_t> PaletteIndex::offered(const QStringList &used) const
{
    std::vector<std::size_t> found;
    for (const QString &id : used)
        if (const auto entry = std::ranges::find(m_entries, id, &PaletteEntry::id); entry != m_entries.end())
            found.push_back(static_cast<std::size_t>(entry - m_entries.begin()));
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        if (m_entries[i].isUsual && !used.contains(m_entries[i].id))
            found.push_back(i);
    return found;
}

} // namespace codewheel
