// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

#include <QStringList>

namespace codewheel {

// Finds entries by words, in any order: all of them, anywhere in title, kind, context, key and further
// words. Words typed on to those before only look at what these found.
class PaletteIndex
{
public:
    void clear();
    void add(std::vector<PaletteEntry> entries);
    bool isEmpty() const { return m_entries.empty(); }
    const PaletteEntry &at(std::size_t entry) const { return m_entries[entry]; }

    // Best first: what has this key; then words at the beginning of a title, of one of its words, of a word
    // elsewhere, then within words. What cannot be done now comes after what can be and fits almost as well,
    // the manual after what can be done, short titles before long ones. Messages follow as they were added,
    // for there may be thousands.
    std::vector<std::size_t> find(const QString &typed);
    // Those used last, in this order, then the usual ones.
    std::vector<std::size_t> offered(const QStringList &used) const;

private:
    struct Folded
    {
        QString text; // title, line break, the rest
        qsizetype title = 0;
        QString key;
    };
    struct Hit
    {
        std::size_t entry = 0;
        int distance = 0;     // the less, the better
        qsizetype length = 0; // of the title
        bool isOff = false;
    };

    static int distanceOf(const QString &word, const Folded &folded); // -1: it is not there
    void keepIfFound(std::size_t entry, const QStringList &words, std::vector<Hit> &hits) const;

    std::vector<PaletteEntry> m_entries;
    std::vector<Folded> m_folded;
    QString m_typed;         // folded, of the last search
    std::vector<Hit> m_hits; // of it, among the first m_searched
    std::size_t m_searched = 0;
};

} // namespace codewheel
