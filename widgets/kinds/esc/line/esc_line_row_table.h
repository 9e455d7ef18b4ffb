// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/row_text.h"
#include "widgets/look/log_table.h"
#include "widgets/models/traffic_model.h"

#include <QSortFilterProxyModel>

namespace codewheel {

// The rows of a line, on request without the program's own requests, which would push away what was typed.
// Hidden rows are kept until there are too many.
class EscLineRowFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit EscLineRowFilter(TrafficModel &rows, QObject *parent = nullptr);

    void hideAutomatic(bool hide);
    bool hidesAutomatic() const { return m_hidesAutomatic; }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    TrafficModel &m_rows;
    bool m_hidesAutomatic = true;
};

// The rows of a line as a table: hides automatic requests and columns as wanted, copies and exports what it
// shows. Used by the terminal and the view of a recorded session.
class EscLineRowTable : public LogTable
{
    Q_OBJECT

public:
    EscLineRowTable(TrafficModel &rows, const QString &name, QWidget *parent = nullptr);
    ~EscLineRowTable() override;

    EscLineRowFilter &filter() { return *m_filter; }
    void showColumn(TrafficColumn column, bool show);
    // Of the row that was chosen last.
    std::optional<Place> chosenPlace() const;

    // The selected rows, or all that are shown: one line per row, tabs between the columns.
    void copy() const;
    // All rows shown, with date and time.
    QString exportText() const;

protected:
    void changeEvent(QEvent *event) override;

private:
    void setColumnWidths();

    TrafficModel &m_rows;
    EscLineRowFilter *m_filter;
};

} // namespace codewheel
