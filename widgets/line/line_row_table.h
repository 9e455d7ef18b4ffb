// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/line/line_row_filter.h"
#include "widgets/line/line_row_model.h"

#include <QTableView>

namespace codewheel {

// The rows of a line as a table: hides the polling and columns as wanted, copies and exports what it shows.
// Used by the terminal and by the view of a kept session.
class LineRowTable : public QTableView
{
    Q_OBJECT

public:
    LineRowTable(LineRowModel &rows, const QString &name, QWidget *parent = nullptr);
    ~LineRowTable() override;

    LineRowFilter &filter() { return *m_filter; }
    void showColumn(LineRowModel::Column column, bool show);

    // The rows chosen, or all that are shown: a row a line, tabs between the columns.
    void copy() const;
    // All rows shown, with date and time.
    QString exportText() const;

protected:
    void changeEvent(QEvent *event) override;

private:
    void setColumnWidths();

    LineRowModel &m_rows;
    LineRowFilter *m_filter;
};

} // namespace codewheel
