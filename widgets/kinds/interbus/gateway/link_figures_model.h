// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/link_figures.h"

#include <QAbstractTableModel>

#include <memory>

namespace codewheel {

// The statistics of a link by transactions: one row per figure, and one for each exception that has come.
class LinkFiguresModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(const std::shared_ptr<const LinkFigures> &figures); // null: none

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row
    {
        QString title;
        QString figure;
        QString toolTip = {}; // empty: the title says it all

        friend bool operator==(const Row &, const Row &) = default;
    };
    static std::vector<Row> rowsOf(const LinkFigures &figures);

    std::shared_ptr<const LinkFigures> m_shown;
    std::vector<Row> m_rows = rowsOf({});
};

} // namespace codewheel
