// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/training/shaft_controls.h"

#include "kinds/interbus/simulator/ring_training_acts.h"
#include "widgets/look/layouts.h"
#include "widgets/training/shaft_fields.h"

#include <QVBoxLayout>

namespace codewheel {

ShaftControls::ShaftControls(const SharedControls &controls, QWidget *parent)
    : QWidget(parent)
    , m_controls(controls)
    , m_fields(new ShaftFields(TrainingControls::fastest, this))
{
    layOut<QVBoxLayout>(this, 0)->addWidget(m_fields);
    connect(m_fields, &ShaftFields::turned, this,
            [this](qint64 steps) { m_controls->turnBy(m_number, steps); });
    connect(m_fields, &ShaftFields::turnedTo, this, [this](int raw) {
        m_controls->turnTo(m_number, raw);
        Q_EMIT acted(ringAct(RingAct::shaftTurnedTo, {std::int64_t{raw}}));
    });
    connect(m_fields, &ShaftFields::speedSet, this, [this](double rpm) {
        m_controls->setSpeed(m_number, rpm);
        Q_EMIT acted(rpm == 0 ? ringAct(RingAct::shaftStopped) : ringAct(RingAct::shaftTurns, {rpm}));
    });
    connect(m_fields, &ShaftFields::leftAlone, this,
            [this](qint64 raw) { Q_EMIT acted(ringAct(RingAct::shaftTurnedByHand, {std::int64_t{raw}})); });
}

void ShaftControls::showShaft(const TrainingControls::Shaft &shaft)
{
    m_number = shaft.number;
    m_fields->showShaft({.raw = shaft.raw,
                         .stepsPerTurn = shaft.stepsPerTurn,
                         .turns = shaft.turns,
                         .revolutionsPerMinute = shaft.revolutionsPerMinute});
}

void ShaftControls::leave()
{
    m_fields->leave();
}

} // namespace codewheel
