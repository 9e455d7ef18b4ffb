// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/training/rod_controls.h"

#include "kinds/interbus/simulator/ring_training_acts.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

namespace codewheel {

using namespace training_fields;

namespace {

constexpr int tenths = 10; // of a mm: the unit of the track
constexpr int placeDecimals = 2;
constexpr double fastest = 10'000; // mm/s

QString placeNumber(double millimetres)
{
    return QLocale().toString(millimetres, 'f', placeDecimals);
}

} // namespace

RodControls::RodControls(const SharedControls &controls, QWidget *parent)
    : QWidget(parent)
    , m_controls(controls)
    , m_track(describe(new QSlider(Qt::Horizontal, this), tr("Magnet on the rod"),
                       tr("Move the magnet by hand: drag, or use the arrow keys and Page Up, Page Down. The "
                          "head is at the left.")))
    , m_place(numberLabel(tr("Place of the magnet in mm"), this))
    , m_target(describe(new DecimalField(this), tr("Place to move the magnet to, in mm"),
                        tr("mm from the head; Enter moves the magnet there")))
    , m_speed(describe(new DecimalField(this), tr("Speed in mm per second"),
                       tr("mm per second; positive is away from the head. The magnet turns round at the "
                          "ends.")))
{
    m_track->setSingleStep(1);
    m_track->setPageStep(10 * tenths);
    QGridLayout *fields = fieldGrid();
    addNumber(fields, 0, tr("Place, mm"), m_place);
    makePlace(fields);
    makeSpeed(fields);
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_track);
    column->addLayout(fields);
    m_inRange =
        addBox(column, tr("Magnet in range"),
               tr("Outside the measuring range the encoder keeps its last position and sets the error "
                  "bit"));
    connect(m_track, &QSlider::valueChanged, this, &RodControls::slide);
    connect(m_inRange, &QCheckBox::clicked, this, &RodControls::setInRange);
}

void RodControls::makePlace(QGridLayout *grid)
{
    prepare(m_target, 8);
    m_target->setDecimals(placeDecimals);
    m_target->setButtonSymbols(QAbstractSpinBox::NoButtons);
    auto *go = buttonBeside(Icon::next, tr("Move the magnet to the place"), this);
    addCaption(grid, 1, tr("Move to"), m_target);
    grid->addWidget(m_target, 1, 1);
    grid->addWidget(go, 1, 2);
    connect(go, &QToolButton::clicked, this, &RodControls::moveTo);
    connect(m_target->findChild<QLineEdit *>(), &QLineEdit::returnPressed, this, &RodControls::moveTo);
}

void RodControls::makeSpeed(QGridLayout *grid)
{
    addSpeed(grid, 2, tr("Speed, mm/s"), m_speed, fastest, tr("Stop the magnet"));
    connect(m_speed, &QDoubleSpinBox::valueChanged, this, &RodControls::setSpeed);
}

void RodControls::showRod(const TrainingControls::Rod &rod)
{
    const bool isNew = !m_shown;
    const TrainingControls::Rod before = std::exchange(m_shown, rod).value_or(TrainingControls::Rod{});
    if (isNew) {
        const QSignalBlocker silent(m_track);
        m_track->setRange(0, qRound(rod.lengthMillimetres * tenths));
        m_target->setRange(0, rod.lengthMillimetres);
        m_target->setValue(rod.millimetres);
    }
    if (isNew || rod.millimetres != before.millimetres)
        showPlace(rod.millimetres);
    if (isNew || rod.millimetresPerSecond != before.millimetresPerSecond) {
        const QSignalBlocker silent(m_speed);
        m_speed->setValue(rod.millimetresPerSecond);
    }
    if (isNew || rod.magnetInRange != before.magnetInRange)
        m_inRange->setChecked(rod.magnetInRange);
    if (m_leftAlone.frame())
        tellOfMoving();
}

void RodControls::showPlace(double millimetres)
{
    m_place->setText(placeNumber(millimetres));
    if (m_track->isSliderDown())
        return;
    const QSignalBlocker silent(m_track);
    m_track->setValue(qRound(millimetres * tenths));
}

void RodControls::leave()
{
    if (m_leftAlone.isMoving())
        tellOfMoving();
    m_shown.reset();
}

void RodControls::slide(int place)
{
    m_controls->moveMagnetTo(m_shown->number, static_cast<double>(place) / tenths);
    m_leftAlone.moved();
}

void RodControls::moveTo()
{
    if (!m_target->takeTyped().isEmpty())
        return; // the field says why
    m_controls->moveMagnetTo(m_shown->number, m_target->value());
    m_leftAlone.forget();
    Q_EMIT acted(ringAct(RingAct::magnetMovedTo, {m_target->value()}));
}

void RodControls::setSpeed(double millimetresPerSecond)
{
    m_controls->setMagnetSpeed(m_shown->number, millimetresPerSecond);
    Q_EMIT acted(millimetresPerSecond == 0 ? ringAct(RingAct::magnetStopped)
                                           : ringAct(RingAct::magnetMoves, {millimetresPerSecond}));
}

void RodControls::setInRange(bool inRange)
{
    m_controls->setFault(TrainingFault::magnetLost, m_shown->number, inRange ? 0 : 1);
    Q_EMIT acted(ringAct(inRange ? RingAct::magnetInRange : RingAct::magnetOutOfRange));
}

void RodControls::tellOfMoving()
{
    m_leftAlone.forget();
    Q_EMIT acted(ringAct(RingAct::magnetMovedByHand, {m_shown->millimetres}));
}

} // namespace codewheel
