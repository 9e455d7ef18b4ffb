// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/link_figures.h"
#include "widgets/models/table_model_base.h"

#include <memory>

namespace codewheel {

struct LinkFigureRow
{
    QString title;
    QString figure;
    QString toolTip = {}; // empty: the title says it all

    friend bool operator==(const LinkFigureRow &, const LinkFigureRow &) = default;
};

// The statistics of a link by transactions: one row per figure, and one for each exception that has come.
class LinkFiguresModel : public TableModelBase<LinkFigureRow>
{
    Q_OBJECT

public:
    explicit LinkFiguresModel(QObject *parent = nullptr);

    void show(const std::shared_ptr<const LinkFigures> &figures); // null: none

protected:
    int columns() const override { return 1; }
    QVariant headerCell(int /*column*/, int /*role*/) const override { return {}; }
    QVariant rowHead(const LinkFigureRow &row, int role) const override;
    QVariant cell(const LinkFigureRow &row, int column, int role) const override;

private:
    static std::vector<LinkFigureRow> rowsOf(const LinkFigures &figures);

    std::shared_ptr<const LinkFigures> m_shown;
};

} // namespace codewheel
