// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace codewheel {

class TransferModel;

// The table of a transfer: sentences below an encoder span the whole row. Used in TransferPage and
// ReplaceWriteStep.
class TransferTable : public QTableView
{
    Q_OBJECT

public:
    TransferTable(TransferModel &model, const QString &name, QWidget *parent = nullptr);

private:
    void spanCells();

    TransferModel &m_model;
};

} // namespace codewheel
