// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_check.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// The registers of each device behind a gateway, and its IN word in the orders it could be meant in, with
// which of them the encoder could have sent.
class WordReadingsModel : public TableModelBase<DeviceRegisters>
{
    Q_OBJECT

public:
    enum Column : std::uint8_t { place, inRegisters, outRegisters, firstOrder };

    using TableModelBase::TableModelBase;

    // `set`: the order in which the words are read now.
    void show(std::vector<DeviceRegisters> devices, WordOrder set);
    // The only order of high or low word first in which all words could be; empty: more than one, or none.
    std::optional<WordOrder> onlyFitting() const;

protected:
    int columns() const override { return firstOrder + 4; }
    QVariant headerCell(int column, int role) const override;
    QString text(const DeviceRegisters &device, int column) const override;
    QVariant cell(const DeviceRegisters &device, int column, int role) const override;

private:
    WordOrder m_set = WordOrder::abcd;
};

// "0–1".
QString registerRange(const RegisterBlock &block);

} // namespace codewheel
