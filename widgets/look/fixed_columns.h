// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QTableView;

namespace codewheel {

// Columns as wide as their widest text from the start, so that nothing moves while the table is shown; the
// last one has the rest.
void fixColumns(QTableView &table, const QStringList &widest);

} // namespace codewheel
