// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/gear_panel.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

namespace codewheel {
namespace {

constexpr double largest = 1'000'000;

QString number(double value, int digits)
{
    return QLocale().toString(value, 'g', digits);
}

} // namespace

GearPanel::GearPanel(QWidget *parent)
    : QGroupBox(tr("From mm and gear"), parent)
    , m_mmPerTurn(makeField(10, 0.001, 4, tr("Travel per turn of the driven part"),
                            tr("mm the machine moves in one turn of its spindle, wheel or drum.")))
    , m_encoderTurns(makeField(1, 0.001, 3, tr("Encoder turns of the gear"), tr("Turns of the encoder ...")))
    , m_partTurns(makeField(1, 0.001, 3, tr("Part turns of the gear"),
                            tr("... while the driven part makes so many turns.")))
    , m_mmPerStep(
          makeField(0.01, 0.00001, 5, tr("Wanted resolution"), tr("mm for one step of the position.")))
    , m_answer(new QLabel(this))
    , m_take(new QPushButton(tr("&Use these"), this))
{
    auto label = [this](const QString &text, QWidget *buddy) {
        auto *made = new QLabel(text, this);
        made->setBuddy(buddy);
        return made;
    };
    auto *layout = new QGridLayout(this);
    layout->setSpacing(grid::unit);
    layout->addWidget(label(tr("&mm per turn"), m_mmPerTurn), 0, 0);
    layout->addWidget(m_mmPerTurn, 0, 1);
    layout->addWidget(label(tr("&Gear, encoder turns"), m_encoderTurns), 1, 0);
    layout->addWidget(m_encoderTurns, 1, 1);
    layout->addWidget(label(tr("to &part turns"), m_partTurns), 2, 0);
    layout->addWidget(m_partTurns, 2, 1);
    layout->addWidget(label(tr("mm per s&tep"), m_mmPerStep), 3, 0);
    layout->addWidget(m_mmPerStep, 3, 1);
    layout->addWidget(m_answer, 4, 0, 1, 2);
    layout->addWidget(m_take, 5, 0);
    layout->setColumnStretch(1, 1);
    m_answer->setWordWrap(true);
    m_answer->setObjectName(QStringLiteral("gearAnswer"));
    m_take->setObjectName(QStringLiteral("gearUse"));
    m_take->setToolTip(tr("Puts these steps and revolutions among the wanted values."));
    connect(m_take, &QPushButton::clicked, this,
            [this] { Q_EMIT chosen(m_result->steps, m_result->revolutions); });
    calculate();
}

QDoubleSpinBox *GearPanel::makeField(double value, double least, int decimals, const QString &name,
                                     const QString &toolTip)
{
    auto *field = new QDoubleSpinBox(this);
    field->setDecimals(decimals);
    field->setRange(least, largest);
    field->setValue(value);
    field->setAlignment(Qt::AlignRight);
    field->setFont(numberFont());
    field->setAccessibleName(name);
    field->setToolTip(toolTip);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    connect(field, &QDoubleSpinBox::valueChanged, this, &GearPanel::calculate);
    return field;
}

void GearPanel::setLimits(const GearLimits &limits)
{
    m_limits = limits;
    calculate();
}

void GearPanel::calculate()
{
    if (m_take == nullptr)
        return; // still being made
    m_result = stepsForGear(
        {m_mmPerTurn->value(), m_encoderTurns->value(), m_partTurns->value(), m_mmPerStep->value()},
        m_limits);
    m_take->setEnabled(m_result.has_value());
    if (!m_result) {
        m_answer->setText(tr("The encoder cannot resolve this. Choose more mm per step."));
        return;
    }
    m_answer->setText(tr("%1 steps in %2 revolutions: %3 mm per step, %4 mm off over %5 mm.")
                          .arg(QLocale().toString(qlonglong{m_result->steps}),
                               QLocale().toString(qlonglong{m_result->revolutions}),
                               number(m_result->mmPerStep, 6), number(m_result->errorOverTravel, 3),
                               number(m_result->travel, 7)));
}

} // namespace codewheel
