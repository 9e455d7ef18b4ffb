// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/known.h"
#include "widgets/models/table_model_base.h"

#include <QString>

namespace codewheel {

struct ValueChangeRow
{
    Parameter parameter = Parameter::steps;
    QString before;
    QString wanted;
    QString action; // "write", "there already", "read first"
};

// Parameter, old, new, what happens.
class ValueChangeTable final : public TableModelBase<ValueChangeRow>
{
    Q_OBJECT

public:
    enum Column { name, before, wanted, action };
    using TableModelBase::TableModelBase;

protected:
    int columns() const override { return 4; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const ValueChangeRow &row, int column, int role) const override;
};

} // namespace codewheel
