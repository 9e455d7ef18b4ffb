// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_table.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// A device that is offered, and the registers of its words.
struct ServedDevice
{
    ServedRegisters registers;
    QString name;

    friend bool operator==(const ServedDevice &, const ServedDevice &) = default;
};

// The register map of an offered ring, for those who write a program for it.
class ServedRegistersModel : public TableModelBase<ServedDevice>
{
    Q_OBJECT

public:
    enum Column : std::uint8_t { place, in, inHolding, out, name };

    using TableModelBase::TableModelBase;

    void show(std::vector<ServedDevice> devices);

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const ServedDevice &device, int column) const override;
    bool isNumber(int column) const override { return column != name; }
};

} // namespace codewheel
