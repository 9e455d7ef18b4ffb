// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_snapshot.h"

#include <QAbstractTableModel>

#include <vector>

namespace codewheel {

// One row per figure; the line in the first column, each encoder in a column of its own.
class EscLineFiguresModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    // Tells the views only what has changed.
    void show(const EscLineSnapshot &line);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Column
    {
        std::optional<EscLineAddress> address; // nothing: the line
        EscLineFigures figures;

        friend bool operator==(const Column &, const Column &) = default;
    };

    std::vector<Column> m_columns{Column{}};
};

} // namespace codewheel
