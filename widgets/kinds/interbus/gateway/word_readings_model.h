// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_check.h"

#include <QAbstractTableModel>

#include <vector>

namespace codewheel {

// The registers of each device behind a gateway, and its IN word in the orders it could be meant in, with
// which of them the encoder could have sent.
class WordReadingsModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column : std::uint8_t { place, inRegisters, outRegisters, firstOrder, columns = firstOrder + 4 };

    using QAbstractTableModel::QAbstractTableModel;

    // `set`: the order in which the words are read now.
    void show(std::vector<DeviceRegisters> devices, WordOrder set);
    const DeviceRegisters &device(int row) const { return m_devices[static_cast<std::size_t>(row)]; }
    // The only order of high or low word first in which all words could be; empty: more than one, or none.
    std::optional<WordOrder> onlyFitting() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    const WordReading *reading(const QModelIndex &index) const;
    QString text(const QModelIndex &index) const;
    QString toolTip(const QModelIndex &index) const;

    std::vector<DeviceRegisters> m_devices;
    WordOrder m_set = WordOrder::abcd;
};

// "0–1".
QString registerRange(const RegisterBlock &block);

} // namespace codewheel
