// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/known.h"
#include "widgets/models/table_model_base.h"

#include <QString>

namespace codewheel {

class EncoderSession;

struct KnownRow
{
    Parameter parameter = Parameter::steps;
    QString value; // with its unit; a dash where it is unknown
    std::optional<Known> known;

    friend bool operator==(const KnownRow &, const KnownRow &) = default;
};

// Parameter, value, how it is known.
class KnownTable final : public TableModelBase<KnownRow>
{
    Q_OBJECT

public:
    enum Column { name, value, evidence };

    using TableModelBase::TableModelBase;

    // Rows of the same device are changed in place.
    void show(const EncoderSession &encoder);

protected:
    int columns() const override { return 3; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const KnownRow &row, int column, int role) const override;
};

} // namespace codewheel
