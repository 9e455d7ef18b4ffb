// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_table.h"

#include "widgets/look/fitted_columns.h"
#include "widgets/look/quiet_table.h"
#include "widgets/transfer/transfer_model.h"

namespace codewheel {

TransferTable::TransferTable(TransferModel &model, const QString &name, QWidget *parent)
    : QTableView(parent)
    , m_model(model)
{
    setUpQuietTable(*this, model, name);
    setSelectionBehavior(QAbstractItemView::SelectItems);
    setToolTip(tr("Space chooses an encoder"));
    connect(&model, &QAbstractItemModel::modelReset, this, &TransferTable::spanCells);
    FittedColumns::useIn(*this, TransferModel::what);
}

void TransferTable::spanCells()
{
    clearSpans();
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const ReviewRow::Kind kind = m_model.rowAt(row).kind;
        if (kind == ReviewRow::Kind::note)
            setSpan(row, TransferModel::what, 1, m_model.columnCount() - TransferModel::what);
        else if (kind == ReviewRow::Kind::head)
            setSpan(row, TransferModel::what, 1, TransferModel::eeprom - TransferModel::what);
    }
}

} // namespace codewheel
