// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_scaling.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// Every command of the protocol after an address, with what it does: offered by the terminal's field while
// one types.
class CommandList : public TableModelBase<esc::CommandShape>
{
    Q_OBJECT

public:
    enum Column { request, meaning };

    explicit CommandList(QObject *parent = nullptr);

    // Two hexadecimal digits, with which the requests begin.
    void setAddress(const QString &digits);
    const QString &address() const { return m_address; }
    // Those of the scaling factor of the line.
    void setFractionBits(int bits);

protected:
    int columns() const override { return meaning + 1; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const esc::CommandShape &shape, int column, int role) const override;

private:
    QString meaningOf(const esc::CommandShape &shape) const;

    QString m_address = QStringLiteral("01");
    int m_fractionBits = esc::defaultFractionBits;
};

} // namespace codewheel
