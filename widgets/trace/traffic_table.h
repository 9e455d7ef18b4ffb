// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/log_table.h"
#include "widgets/models/traffic_model.h"

#include <QSortFilterProxyModel>

#include <functional>

namespace codewheel {

// The rows of a bus, on request without the program's own requests, which would push away what was typed, and
// only those that are wanted. Hidden rows are kept until there are too many.
class TrafficFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit TrafficFilter(TrafficModel &rows, QObject *parent = nullptr);

    void hideAutomatic(bool hide);
    bool hidesAutomatic() const { return m_hidesAutomatic; }
    void setWanted(std::function<bool(const TrafficRow &row)> isWanted);

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    TrafficModel &m_rows;
    bool m_hidesAutomatic = true;
    std::function<bool(const TrafficRow &)> m_isWanted; // null: all
};

// The rows of a bus as a table: hides rows and columns as wanted, copies and exports what it shows.
class TrafficTable : public LogTable
{
    Q_OBJECT

public:
    TrafficTable(TrafficModel &rows, const QString &name, QWidget *parent = nullptr);
    ~TrafficTable() override;

    TrafficFilter &filter() { return *m_filter; }
    void showColumn(TrafficColumn column, bool show);
    // Of the row that was chosen last.
    std::optional<Place> chosenPlace() const;

    // The selected rows, or all that are shown: one line per row, tabs between the columns.
    void copy() const;
    // All rows shown, with date and time.
    QString exportText() const;

private:
    bool has(TrafficColumn column) const;
    void setColumnWidths();

    TrafficModel &m_rows;
    TrafficFilter *m_filter;
};

} // namespace codewheel
