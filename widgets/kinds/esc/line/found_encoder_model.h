// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_scan.h"
#include "widgets/models/table_model_base.h"

#include <set>

namespace codewheel {

// The encoders found by a search; those to be taken over are ticked.
class FoundEncoderModel : public TableModelBase<FoundEncoder>
{
    Q_OBJECT

public:
    enum Column { address, baudRate, serialNumber, deviceCode, version };

    using TableModelBase::TableModelBase;

    // Rows that exist already stay as they are.
    void show(const std::vector<FoundEncoder> &found);
    void clear();
    std::vector<FoundEncoder> chosen() const;

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void chosenChanged();

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const FoundEncoder &row, int column) const override;
    bool isNumber(int column) const override { return column != version; }
    QVariant cell(const FoundEncoder &row, int column, int role) const override;

private:
    using Key = std::pair<EscLineAddress, int>; // with its baud rate
    static Key keyOf(const FoundEncoder &found) { return {found.address, found.baudRate}; }
    bool canBeTaken(const FoundEncoder &row) const;

    std::set<Key> m_left; // not to be taken over
};

} // namespace codewheel
