// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/comparison.h"
#include "bus/not_live.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

class PlanEdits;
struct ConnectedBus;

struct ComparisonRow
{
    std::size_t line = 0; // of the comparison
    ComparisonKind kind = ComparisonKind::same;
    QString configured; // "3.0  FRABA OCD-IB K3  37h"; empty: it has none
    QString connected;
    QString text;                 // in words; empty: the same
    std::optional<NotLive> old{}; // of the connected one
};

// The configured bus beside the connected one, line by line.
class ComparisonModel : public TableModelBase<ComparisonRow>
{
    Q_OBJECT

public:
    enum Column { configuredColumn, connectedColumn, differenceColumn };

    using TableModelBase::TableModelBase;

    void compare(const PlanEdits &plan, const ConnectedBus &connected, bool onlyDifferences);
    const Comparison &comparison() const { return m_comparison; }

protected:
    std::span<const ColumnHead> heads() const override;
    QVariant cell(const ComparisonRow &row, int column, int role) const override;

private:
    static QString textOf(const ComparisonRow &row, int column);

    Comparison m_comparison;
};

} // namespace codewheel
