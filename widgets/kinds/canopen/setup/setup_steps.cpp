// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/setup/setup_steps.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/role_label.h"

#include <QVBoxLayout>

namespace codewheel {

SetupSteps::SetupSteps(QWidget *parent)
    : QWidget(parent)
    , m_column(layOut<QVBoxLayout>(this, grid::unit))
{
    describe(this, tr("Steps"), tr("What is done, one after the other"));
}

void SetupSteps::show(const std::vector<Row> &rows)
{
    using enum canopen::NodeSetup::StepState;
    while (m_rows.size() > rows.size()) {
        delete m_rows.back();
        m_rows.pop_back();
    }
    while (m_rows.size() < rows.size()) {
        m_rows.push_back(new RoleLabel(this));
        m_rows.back()->setWrapping();
        m_column->addWidget(m_rows.back());
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto &[state, text] = rows[i];
        if (state == done)
            m_rows[i]->setState(Role::running, tr("done: %1").arg(text));
        else if (state == failed)
            m_rows[i]->setState(Role::fault, tr("failed: %1").arg(text));
        else if (state == now)
            m_rows[i]->setState(Role::attention, tr("now: %1").arg(text));
        else if (state == leftOut)
            m_rows[i]->setState(Role::inactive, tr("left out: %1").arg(text));
        else
            m_rows[i]->setState(Role::inactive, tr("planned: %1").arg(text));
    }
    setVisible(!rows.empty());
}

QStringList SetupSteps::shown() const
{
    QStringList shown;
    for (const RoleLabel *row : m_rows)
        shown << row->word();
    return shown;
}

} // namespace codewheel
