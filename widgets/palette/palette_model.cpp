// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/palette/palette_model.h"

#include "widgets/palette/folded_text.h"
#include "widgets/palette/palette_kind.h"

#include <algorithm>

namespace codewheel {
namespace {

PaletteState stateOf(const PaletteEntry &entry)
{
    return entry.state ? entry.state() : PaletteState{};
}

// "Action · View > Panels", or "Action · not available now · No encoder is chosen."
QString contextOf(const PaletteEntry &entry)
{
    const PaletteState state = stateOf(entry);
    QStringList parts{kindWord(entry.kind)};
    if (state.isEnabled)
        parts << entry.context << whatReturnDoes(entry);
    else
        parts << PaletteModel::tr("not available now") << state.reason;
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" \u00B7 "));
}

// What was found by none of what is shown shows why it was found.
QString contextOf(const PaletteEntry &entry, const QStringList &words)
{
    const QString context = contextOf(entry);
    const QString shown = foldedText(entry.title + u'\n' + context + u'\n' + entry.key);
    const bool isSeen = std::ranges::all_of(words, [&](const QString &word) { return shown.contains(word); });
    return isSeen || entry.words.isEmpty() ? context
                                           : QStringLiteral("%1 \u00B7 %2").arg(context, entry.words);
}

QString inFull(const PaletteEntry &entry, const QStringList &words)
{
    QStringList lines{entry.title, contextOf(entry, words), entry.key};
    lines.removeAll(QString());
    return lines.join(u'\n');
}

} // namespace

void PaletteModel::clear()
{
    beginResetModel();
    m_index.clear();
    m_rows.clear();
    m_typed.clear();
    m_words.clear();
    endResetModel();
}

void PaletteModel::setUsed(const QStringList &ids)
{
    m_used = ids;
}

void PaletteModel::add(std::vector<PaletteEntry> entries)
{
    m_index.add(std::move(entries));
    list();
}

void PaletteModel::setTyped(const QString &typed)
{
    m_typed = typed;
    m_words = foldedWords(typed);
    list();
}

void PaletteModel::list()
{
    std::vector<std::size_t> rows = m_words.isEmpty() ? m_index.offered(m_used) : m_index.find(m_typed);
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

int PaletteModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant PaletteModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const PaletteEntry &its = entry(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return its.title;
    case Qt::DecorationRole:
        return its.icon.isNull() ? kindIcon(its.kind) : its.icon;
    case Qt::ToolTipRole:
        return inFull(its, m_words);
    case Qt::AccessibleTextRole:
        return inFull(its, m_words).replace(QStringLiteral("\n"), QStringLiteral(", "));
    case contextRole:
        return contextOf(its, m_words);
    case keyRole:
        return its.key;
    case isEnabledRole:
        return stateOf(its).isEnabled;
    default:
        return {};
    }
}

} // namespace codewheel
