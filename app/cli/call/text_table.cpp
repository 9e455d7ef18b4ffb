// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/text_table.h"

#include "vocabulary/shown_text.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype gap = 2;

QString withoutTrailingSpaces(QString line)
{
    while (line.endsWith(u' '))
        line.chop(1);
    return line;
}

} // namespace

void TextTable::add(QStringList cells)
{
    std::ranges::transform(cells, cells.begin(), shownInLine);
    widen(cells);
    m_lines.push_back(std::move(cells));
}

QString TextTable::next(QStringList cells)
{
    std::ranges::transform(cells, cells.begin(), shownInLine);
    widen(cells);
    return line(cells, 0);
}

void TextTable::widen(const QStringList &cells)
{
    m_widths.resize(std::max(m_widths.size(), static_cast<std::size_t>(cells.size())));
    for (qsizetype i = 0; i < cells.size(); ++i) {
        qsizetype &width = m_widths[static_cast<std::size_t>(i)];
        width = std::max(width, cells[i].size());
    }
}

QString TextTable::line(const QStringList &cells, int indent) const
{
    QString line(indent, u' ');
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells.size()); ++i) {
        const QString &cell = cells[static_cast<qsizetype>(i)];
        const bool right = i < m_columns.size() && m_columns[i] == Align::right;
        line += right ? cell.rightJustified(m_widths[i]) : cell.leftJustified(m_widths[i]);
        line += QString(gap, u' ');
    }
    return withoutTrailingSpaces(line) + u'\n';
}

QString TextTable::toString(int indent) const
{
    QString text;
    for (const QStringList &cells : m_lines)
        text += line(cells, indent);
    return text;
}

QString rowTime(Instant at)
{
    constexpr double microseconds = 1'000; // a millisecond
    return QLocale().toString(static_cast<double>(at.count()) / microseconds, 'f', 1);
}

} // namespace codewheel
