// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/consequences.h"

#include "catalog/protocol_rules.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/wizard/rod_consequences.h"
#include "widgets/wizard/shaft_consequences.h"

namespace codewheel {

Consequences::Consequences(Setup &setup, QWidget *parent)
    : QWidget(parent)
    , m_setup(setup)
    , m_scale(wrappedLabel(this, "scaleText"))
    , m_warning(named(new InlineMessage(this), "scaleWarning"))
{}

void Consequences::layOut(LayoutPart calculator)
{
    layOutColumn(this, {m_scale, m_warning, calculator}, {.spacing = grid::margin, .margins = QMargins()});
}

void Consequences::tell(const QString &scale, const QString &warning)
{
    m_scale->setText(scale);
    if (warning.isEmpty())
        m_warning->withdraw();
    else if (warning != m_warning->sentence())
        m_warning->showMessage(Role::attention, warning);
}

Consequences *Consequences::make(Setup &setup, QWidget *parent)
{
    if (isRod(setup.encoder->device()))
        return new RodConsequences(setup, parent);
    return new ShaftConsequences(setup, parent);
}

} // namespace codewheel
