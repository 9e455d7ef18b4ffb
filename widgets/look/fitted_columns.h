// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QTableView;

namespace codewheel {

class WrappedCells;

// Shares the width of a small table among its columns so that nothing in it is cut off: each has its longest
// text on one line as long as there is room. Where there is not, the widest of them take more lines, and none
// is narrower than its longest word, if need be in small type. Hidden columns take nothing. Cells that span
// columns wrap in all of these.
class FittedColumns : public QObject
{
    Q_OBJECT

public:
    // `stretched` has what is left over. If its texts may be elided (may_elide.h, said before), they stay on
    // one line, and the others have theirs first.
    static void useIn(QTableView &table, int stretched);

private:
    FittedColumns(QTableView &table, int stretched);
    void follow();
    void fitSoon();
    void fit();

    QTableView &m_table;
    const int m_stretched;
    WrappedCells *m_cells;
    bool m_isDue = false;
};

} // namespace codewheel
