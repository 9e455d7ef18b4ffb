// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/training/esc_line_encoder_box.h"

#include "widgets/input/number_fields.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/hand_wheel.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace codewheel {

using namespace training_fields;

EscEncoderBox::EscEncoderBox(QWidget *parent)
    : QWidget(parent)
    , m_wheel(new HandWheel(this))
    , m_raw(numberLabel(tr("Raw position"), this))
    , m_speed(new DecimalField(this))
    , m_troubles{{
          {&EscCondition::powered, LineTrouble::powered,
           tr("Supply of the encoder; it keeps what was written")},
          {&EscCondition::mute, LineTrouble::mute, tr("It receives and acts, but does not answer")},
          {&EscCondition::batteryLimit, LineTrouble::batteryLimit, tr("Warning: soon to be changed")},
          {&EscCondition::batteryFlat, LineTrouble::batteryFlat, tr("Alarm")},
          {&EscCondition::temperatureExceeded, LineTrouble::temperatureExceeded,
           tr("Alarm: temperature exceeded")},
          {&EscCondition::lightControl, LineTrouble::lightControl, tr("Warning")},
          {&EscCondition::positionError, LineTrouble::positionError, tr("Alarm")},
          {&EscCondition::vrHigh, LineTrouble::vrHigh, tr("The input makes the values fall")},
          {&EscCondition::stOpen, LineTrouble::stOpen, tr("RS-422: without +UB at ST no command works")},
      }}
{
    QGridLayout *fields = fieldGrid();
    addNumber(fields, 0, tr("Raw position"), m_raw);
    m_speed->setAccessibleName(tr("Speed in revolutions per minute"));
    m_speed->setToolTip(tr("Revolutions per minute; positive is clockwise, looking at the shaft"));
    addSpeed(fields, 1, tr("Speed, rpm"), m_speed, TurningShaft::fastest, tr("Stop the shaft"));

    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_wheel);
    column->addLayout(fields);
    for (Trouble &trouble : m_troubles) {
        trouble.box = addBox(column, lineTroubleName(trouble.name), trouble.toolTip);
        connect(trouble.box, &QCheckBox::clicked, this,
                [this, &trouble](bool ticked) { set(trouble, ticked); });
    }
    connect(m_wheel, &HandWheel::turned, this, &EscEncoderBox::turnBy);
    connect(m_speed, &QDoubleSpinBox::valueChanged, this, &EscEncoderBox::setSpeed);
}

void EscEncoderBox::showEncoder(SimulatedEscLine &line, EscLineAddress address)
{
    m_line = &line;
    m_address = address;
    line.withEncoder(address, [this](SimulatedEscEncoder &encoder) {
        showShaft(encoder.shaft());
        for (const Trouble &trouble : m_troubles)
            trouble.box->setChecked(encoder.condition().*trouble.flag);
    });
}

void EscEncoderBox::showShaft(const TurningShaft &shaft)
{
    m_wheel->setStepsPerTurn(shaft.resolution().stepsPerTurn);
    m_wheel->showRaw(shaft.raw());
    m_raw->setText(QLocale().toString(qlonglong{shaft.raw()}));
    if (m_speed->hasFocus() || shaft.speed() == m_speed->value())
        return; // what was refused stays to be corrected
    const QSignalBlocker silent(m_speed);
    m_speed->setValue(shaft.speed());
}

void EscEncoderBox::turnBy(qint64 steps)
{
    m_line->withEncoder(m_address, [steps](SimulatedEscEncoder &encoder) { encoder.shaft().turnBy(steps); });
}

void EscEncoderBox::setSpeed(double rpm)
{
    m_line->withEncoder(m_address, [rpm](SimulatedEscEncoder &encoder) { encoder.shaft().setSpeed(rpm); });
    Q_EMIT acted(lineAct(LineAct::shaftSpeed, {rpm}));
}

void EscEncoderBox::set(const Trouble &trouble, bool ticked)
{
    m_line->withEncoder(m_address,
                        [&](SimulatedEscEncoder &encoder) { encoder.condition().*trouble.flag = ticked; });
    Q_EMIT acted(lineTroubleAct(trouble.name, ticked));
}

} // namespace codewheel
