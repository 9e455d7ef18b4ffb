// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_table.h"

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
    horizontalHeader()->setSectionResizeMode(TransferModel::place, QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(TransferModel::what, QHeaderView::Stretch);
    connect(&model, &QAbstractItemModel::modelReset, this, &TransferTable::spanNotes);
}

void TransferTable::spanNotes()
{
    clearSpans();
    for (int row = 0; row < m_model.rowCount(); ++row)
        if (m_model.rowAt(row).kind == ReviewRow::Kind::note)
            setSpan(row, TransferModel::what, 1, m_model.columnCount() - TransferModel::what);
}

} // namespace codewheel
