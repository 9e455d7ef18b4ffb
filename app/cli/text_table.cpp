// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/text_table.h"

#include "encoder/shown_text.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype gap = 2;

std::vector<qsizetype> widthsOf(const std::vector<QStringList> &lines)
{
    std::vector<qsizetype> widths;
    for (const QStringList &cells : lines) {
        widths.resize(std::max(widths.size(), static_cast<std::size_t>(cells.size())));
        for (qsizetype i = 0; i < cells.size(); ++i) {
            qsizetype &width = widths[static_cast<std::size_t>(i)];
            width = std::max(width, cells[i].size());
        }
    }
    return widths;
}

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
    m_lines.push_back(std::move(cells));
}

QString TextTable::toString(int indent) const
{
    const std::vector<qsizetype> widths = widthsOf(m_lines);
    QString text;
    for (const QStringList &cells : m_lines) {
        QString line(indent, u' ');
        for (std::size_t i = 0; i < static_cast<std::size_t>(cells.size()); ++i) {
            const QString &cell = cells[static_cast<qsizetype>(i)];
            const bool right = i < m_columns.size() && m_columns[i] == Align::right;
            line += right ? cell.rightJustified(widths[i]) : cell.leftJustified(widths[i]);
            line += QString(gap, u' ');
        }
        text += withoutTrailingSpaces(line) + u'\n';
    }
    return text;
}

QString rowTime(Instant at)
{
    constexpr double microseconds = 1'000; // a millisecond
    return QLocale().toString(static_cast<double>(at.count()) / microseconds, 'f', 1);
}

} // namespace codewheel
