// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/rod_consequences.h"

#include "catalog/device_description.h"
#include "vocabulary/rod_scale.h"
#include "vocabulary/sentence.h"
#include "widgets/dial/resolution.h"
#include "widgets/wizard/rod_panel.h"

#include <QLocale>

namespace codewheel {

RodConsequences::RodConsequences(Setup &setup, QWidget *parent)
    : Consequences(setup, parent)
    , m_calculator(new RodPanel(this))
{
    if (const auto length = m_setup.valueNow(Parameter::rodLength))
        m_calculator->setRodLength(millimetresOf(*length));
    if (const ParameterDescription *length = m_setup.encoder->device().find(Parameter::measuringLength))
        m_calculator->setMostSteps(length->maximum);
    layOut({m_calculator, 1, Qt::AlignTop});
    connect(m_calculator, &RodPanel::chosen, this, [this](qint64 steps) {
        m_setup.encoder->tell(Parameter::rodLength, micrometresOf(m_calculator->rodLength()));
        Q_EMIT chosen({{Parameter::measuringLength, steps}});
    });
}

void RodConsequences::refresh()
{
    tell(scaleText(), warning());
}

QString RodConsequences::scaleText() const
{
    const auto steps = m_setup.valueAfter(Parameter::measuringLength);
    const auto length = m_setup.valueNow(Parameter::rodLength);
    if (!steps)
        return tr("The resolution is shown once the measuring length is known or wanted.");
    if (!length)
        return tr("Positions from 0 to %1. For mm, calculate the measuring length from the length of the "
                  "rod, or set that length under What is known.")
            .arg(numberText(*steps));
    return tr("Positions from 0 to %1 over %2 mm: %3.")
        .arg(numberText(*steps), QLocale().toString(millimetresOf(*length), 'g', 7),
             resolution(RodScale{*steps, *length}.millimetres(1)));
}

// Warns only: what the manual leaves open is not refused.
QString RodConsequences::warning() const
{
    const auto steps = m_setup.valueAfter(Parameter::measuringLength);
    const auto preset = m_setup.valueAfter(Parameter::externalPreset);
    if (steps && preset && *preset > *steps)
        return tr("The external preset %1 lies beyond the measuring length of %2 steps.")
            .arg(numberText(*preset), numberText(*steps));
    if (steps && m_setup.wish.setPositionTo && *m_setup.wish.setPositionTo > *steps)
        return tr("The position to be set, %1, lies beyond the measuring length of %2 steps.")
            .arg(numberText(*m_setup.wish.setPositionTo), numberText(*steps));
    return {};
}

} // namespace codewheel
