// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// The steps on the way of the data, what is expected beside what came. Rows stay while they are refreshed.
class DataCheckModel : public TableModelBase<DataCheck>
{
    Q_OBJECT

public:
    enum Column { whatColumn, expectedColumn, cameColumn };

    using TableModelBase::TableModelBase;

    void show(const DataChecks &checks); // changes nothing but what differs
    int rowOf(DataCheck::Id id) const;   // -1: there is none

protected:
    std::span<const ColumnHead> heads() const override;
    QVariant cell(const DataCheck &check, int column, int role) const override;

private:
    bool hasSteps(const DataChecks &checks) const;
};

} // namespace codewheel
