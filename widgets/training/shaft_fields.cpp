// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/shaft_fields.h"

#include "widgets/input/number_fields.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/hand_wheel.h"
#include "widgets/training/training_fields.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <limits>

namespace codewheel {

using namespace training_fields;

ShaftFields::ShaftFields(double fastest, QWidget *parent)
    : QWidget(parent)
    , m_wheel(new HandWheel(this))
    , m_raw(numberLabel(tr("Raw position"), this))
    , m_turn(numberLabel(tr("Turn"), this))
    , m_target(new IntegerField(this))
    , m_speed(new DecimalField(this))
{
    auto *numbers = new QGridLayout;
    numbers->setVerticalSpacing(grid::unit / 2);
    numbers->setColumnStretch(1, 1);
    addNumber(numbers, 0, tr("Raw position"), m_raw);
    addNumber(numbers, 1, tr("Turn"), m_turn);
    QGridLayout *fields = fieldGrid();
    makePosition(fields);
    makeSpeed(fields, fastest);
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_wheel);
    column->addLayout(numbers);
    column->addLayout(fields);
    connect(m_wheel, &HandWheel::turned, this, &ShaftFields::turnBy);
}

void ShaftFields::makePosition(QGridLayout *grid)
{
    prepare(m_target, 8);
    m_target->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_target->setAccessibleName(tr("Raw position to turn to"));
    m_target->setToolTip(tr("Raw position, in the encoder's own steps; Enter turns the shaft to it"));
    auto *go = buttonBeside(Icon::shaft, tr("Turn to the raw position"), this);
    addCaption(grid, 0, tr("Turn to"), m_target);
    grid->addWidget(m_target, 0, 1);
    grid->addWidget(go, 0, 2);
    connect(go, &QToolButton::clicked, this, &ShaftFields::turnTo);
    connect(m_target->findChild<QLineEdit *>(), &QLineEdit::returnPressed, this, &ShaftFields::turnTo);
}

void ShaftFields::makeSpeed(QGridLayout *grid, double fastest)
{
    m_speed->setAccessibleName(tr("Speed in revolutions per minute"));
    m_speed->setToolTip(tr("Revolutions per minute; positive is clockwise, looking at the shaft"));
    addSpeed(grid, 1, tr("Speed, rpm"), m_speed, fastest, tr("Stop the shaft"));
    connect(m_speed, &QDoubleSpinBox::valueChanged, this, &ShaftFields::speedSet);
}

void ShaftFields::showShaft(const Shaft &shaft)
{
    const bool isNew = !m_shown;
    const Shaft before = std::exchange(m_shown, shaft).value_or(Shaft{});
    if (isNew) {
        const std::int64_t last = std::int64_t{shaft.stepsPerTurn} * shaft.turns - 1;
        m_target->setRange(0,
                           static_cast<int>(std::min<std::int64_t>(last, std::numeric_limits<int>::max())));
        m_target->setValue(static_cast<int>(shaft.raw));
        m_wheel->setStepsPerTurn(shaft.stepsPerTurn);
    }
    if (isNew || shaft.raw != before.raw) {
        m_raw->setText(QLocale().toString(qint64{shaft.raw}));
        m_turn->setText(QLocale().toString(qint64{shaft.raw / shaft.stepsPerTurn}));
        m_wheel->showRaw(shaft.raw);
    }
    if (isNew || shaft.revolutionsPerMinute != before.revolutionsPerMinute) {
        const QSignalBlocker silent(m_speed);
        m_speed->setValue(shaft.revolutionsPerMinute);
    }
    if (m_leftAlone.frame())
        tellOfTurning();
}

void ShaftFields::leave()
{
    if (m_leftAlone.isMoving())
        tellOfTurning();
    m_shown.reset();
}

void ShaftFields::turnBy(qint64 steps)
{
    Q_EMIT turned(steps);
    m_leftAlone.moved();
}

void ShaftFields::turnTo()
{
    if (!m_target->takeTyped().isEmpty())
        return; // the field says why
    m_leftAlone.forget();
    Q_EMIT turnedTo(m_target->value());
}

void ShaftFields::tellOfTurning()
{
    m_leftAlone.forget();
    Q_EMIT leftAlone(m_shown->raw);
}

} // namespace codewheel
