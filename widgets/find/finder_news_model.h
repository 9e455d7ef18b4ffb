// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/found.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// What a search has heard and found, in the order in which it came.
class FinderNewsModel : public TableModelBase<FinderNews>
{
    Q_OBJECT

public:
    enum Column : std::uint8_t { place, settings, sure, what };

    using TableModelBase::TableModelBase;

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const FinderNews &news, int column) const override;
    QVariant cell(const FinderNews &news, int column, int role) const override;
};

} // namespace codewheel
