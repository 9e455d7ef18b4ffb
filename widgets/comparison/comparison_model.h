// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/comparison.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

struct ComparisonRow
{
    std::size_t line = 0; // of the comparison
    ComparisonKind kind = ComparisonKind::same;
    QString configured; // "3.0  FRABA OCD-IB K3  37h"; empty: it has none
    QString connected;
    QString text; // in words; empty: the same
};

// The configured ring beside the connected one, line by line.
class ComparisonModel : public TableModelBase<ComparisonRow>
{
    Q_OBJECT

public:
    enum Column { configuredColumn, connectedColumn, differenceColumn };

    using TableModelBase::TableModelBase;

    void compare(const RingStructure &configured, const RingStructure &connected, const Catalog &catalog,
                 bool onlyDifferences);
    const Comparison &comparison() const { return m_comparison; }
    int differences() const;

protected:
    int columns() const override { return differenceColumn + 1; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const ComparisonRow &row, int column, int role) const override;

private:
    Comparison m_comparison;
};

// How many lines of it are not the same.
int differences(const Comparison &comparison);

} // namespace codewheel
