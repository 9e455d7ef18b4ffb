// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/training/ring_faults.h"

#include "kinds/interbus/simulator/ring_training_acts.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

using namespace training_fields;

namespace {

std::optional<int> valueOf(const TrainingPlace &place, TrainingFault fault)
{
    const auto found = std::ranges::find(place.faults, fault, &TrainingPlace::Standing::fault);
    return found == place.faults.end() ? std::nullopt : std::optional(found->value);
}

} // namespace

RingFaults::RingFaults(const SharedControls &controls, QWidget *parent)
    : QWidget(parent)
    , m_controls(controls)
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    addBoxFor(column, TrainingFault::wireBreak,
              tr("The cable before the device: the bus fails, and the master finds the place"));
    addBoxFor(column, TrainingFault::noSupply, tr("The whole device: the ring is interrupted at it"));
    addBoxFor(column, TrainingFault::wrongDevice,
              tr("A K2 is there instead of what is configured: the bus fails"));
    addBoxFor(column, TrainingFault::peripheralFault,
              tr("The device reports it. The bus goes on; the fault stays until it is confirmed."));
    addBoxFor(column, TrainingFault::camOutOfRange, tr("IN 98000004, by itself"));
    addRate(column);
}

void RingFaults::addBoxFor(QVBoxLayout *column, TrainingFault fault, const QString &toolTip)
{
    QCheckBox *box = addBox(column, trainingFaultName(fault), toolTip);
    connect(box, &QCheckBox::clicked, this, [this, fault](bool on) { set(fault, on ? 1 : 0); });
    m_boxes[fault] = box;
}

void RingFaults::addRate(QVBoxLayout *column)
{
    m_rateRow = new QWidget(this);
    // Below each other, since a dock is narrow.
    auto *row = layOut<QVBoxLayout>(m_rateRow, grid::unit);
    auto *caption = new QLabel(tr("CRC errors per 1000"), m_rateRow);
    m_rate = describe(new IntegerField(m_rateRow), tr("CRC errors of 1000 data cycles"),
                      tr("Faulty data cycles of 1000 in the segment of the device"));
    prepare(m_rate, 4);
    m_rate->setRange(0, mostCrcErrors);
    caption->setBuddy(m_rate);
    row->addWidget(caption);
    row->addWidget(m_rate);
    row->addWidget(wrongInput(m_rate, m_rateRow));
    column->addWidget(m_rateRow);
    connect(m_rate, &QSpinBox::valueChanged, this, [this](int value) {
        if (m_shown && valueOf(*m_shown, TrainingFault::crcErrors) != value)
            set(TrainingFault::crcErrors, value);
    });
}

void RingFaults::set(TrainingFault fault, int value)
{
    m_controls->setFault(fault, m_shown->number, value);
    Q_EMIT acted(faultAct(fault, m_shown->number, value));
}

// A field changes only when the ring has changed, so as not to undo what the user has just ticked before the
// bus has taken it.
void RingFaults::showPlace(const TrainingPlace &place)
{
    const bool isOther = !m_shown || m_shown->number != place.number;
    const auto before = std::exchange(m_shown, place);
    for (const auto &[fault, box] : m_boxes) {
        const auto value = valueOf(place, fault);
        box->setVisible(value.has_value());
        if (value && (isOther || valueOf(*before, fault) != value))
            box->setChecked(*value > 0);
    }
    const auto rate = valueOf(place, TrainingFault::crcErrors);
    m_rateRow->setVisible(rate.has_value());
    if (rate && (isOther || valueOf(*before, TrainingFault::crcErrors) != rate))
        m_rate->setValue(*rate);
}

} // namespace codewheel
