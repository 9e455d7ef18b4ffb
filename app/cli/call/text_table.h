// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <QStringList>

#include <vector>

namespace codewheel {

// Lines of text in columns, two spaces apart, for the terminal. A line without columns is empty.
class TextTable
{
public:
    enum class Align { left, right };

    // `columns` that are not given are aligned left.
    explicit TextTable(std::vector<Align> columns = {})
        : m_columns(std::move(columns))
    {}

    // What would control the terminal, or break the line, is escaped.
    void add(QStringList cells);
    // Every line ends with a line break and without trailing spaces.
    QString toString(int indent = 0) const;
    // A line that is printed at once, and not kept: in columns as wide as those before it have needed.
    QString next(QStringList cells);

private:
    void widen(const QStringList &cells);
    QString line(const QStringList &cells, int indent) const;

    std::vector<Align> m_columns;
    std::vector<qsizetype> m_widths;
    std::vector<QStringList> m_lines;
};

// "1204.5": milliseconds on the clock of a bus.
QString rowTime(Instant at);

// For a cell that has nothing to say.
inline QString orDash(const QString &text)
{
    return text.isEmpty() ? QStringLiteral("-") : text;
}

} // namespace codewheel
