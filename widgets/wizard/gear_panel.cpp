// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/gear_panel.h"

#include "catalog/value_text.h"
#include "widgets/input/form_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/wizard/calculator_field.h"

#include <QGridLayout>
#include <QLocale>
#include <QPushButton>

#include <array>

namespace codewheel {
namespace {

QString gearNumber(double value, int digits)
{
    return QLocale().toString(value, 'g', digits);
}

} // namespace

GearPanel::GearPanel(QWidget *parent)
    : QGroupBox(tr("From mm and gear"), parent)
    , m_answer(wrappedLabel(this, "gearAnswer"))
    , m_take(new QPushButton(tr("&Use these"), this))
{
    auto *layout = new QGridLayout(this);
    layout->setSpacing(grid::unit);
    const auto changed = [this] { calculate(); };
    m_mmPerTurn =
        addCalculatorField(*layout, *this,
                           {tr("&mm per turn"), tr("Travel per turn of the driven part"),
                            tr("mm the machine moves in one turn of its spindle, wheel or drum."), 0.001, 4},
                           10, changed);
    m_encoderTurns = addCalculatorField(
        *layout, *this,
        {tr("&Gear ratio encoder"), tr("Encoder turns of the gear"), tr("Turns of the encoder …"), 0.001, 3},
        1, changed);
    m_partTurns = addCalculatorField(*layout, *this,
                                     {tr("to &load"), tr("Part turns of the gear"),
                                      tr("… while the driven part makes so many turns."), 0.001, 3},
                                     1, changed);
    m_mmPerStep = addCalculatorField(
        *layout, *this,
        {tr("mm per s&tep"), tr("Wanted resolution"), tr("mm for one step of the position."), 0.00001, 5},
        0.01, changed);
    layout->addWidget(m_take, layout->rowCount(), 0);
    layout->addWidget(m_answer, layout->rowCount(), 0, 1, 3);
    layout->setColumnStretch(2, 1); // the fields are as wide as a number
    describe(m_take, "gearUse", tr("Adds these steps and revolutions to the wanted values."));
    connect(m_take, &QPushButton::clicked, this, &GearPanel::take);
    calculate();
}

void GearPanel::setLimits(const GearLimits &limits)
{
    m_limits = limits;
    calculate();
}

void GearPanel::calculate()
{
    const std::array<const DecimalField *, 4> fields{m_mmPerTurn, m_encoderTurns, m_partTurns, m_mmPerStep};
    const QString wrong = firstComplaint(fields);
    m_result.reset();
    if (wrong.isEmpty())
        m_result = stepsForGear(
            {m_mmPerTurn->value(), m_encoderTurns->value(), m_partTurns->value(), m_mmPerStep->value()},
            m_limits);
    m_take->setEnabled(m_result.has_value());
    if (!m_result) {
        m_answer->setText(wrong.isEmpty() ? tr("The encoder cannot resolve this. Choose more mm per step.")
                                          : wrong);
        return;
    }
    m_answer->setText(tr("%1 steps in %2 %6: %3 mm per step, %4 mm off over %5 mm.")
                          .arg(QLocale().toString(qlonglong{m_result->steps}),
                               QLocale().toString(qlonglong{m_result->revolutions}),
                               gearNumber(m_result->mmPerStep, 6), gearNumber(m_result->errorOverTravel, 3),
                               gearNumber(m_result->travel, 7),
                               unitText(Unit::revolutions, m_result->revolutions)));
}

// What is still being typed counts.
void GearPanel::take()
{
    if (takeFields(*this).isEmpty() && m_result)
        Q_EMIT chosen(m_result->steps, m_result->revolutions);
}

} // namespace codewheel
