// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QHeaderView;
class QTableView;

namespace codewheel {

// The least width of a column for its heading. Qt's hint is for a bold one, as in the column of the current
// cell, which our tables do not have.
int headingWidth(const QHeaderView &header, int column);

// Columns as wide as their widest text from the start, so that nothing moves while the table is shown; the
// last one has the rest.
void fixColumns(QTableView &table, const QStringList &widest);

} // namespace codewheel
