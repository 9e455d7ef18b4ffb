// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/training/other_devices_box.h"

#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace codewheel {

using namespace training_fields;

OtherDevicesBox::OtherDevicesBox(QWidget *parent)
    : QWidget(parent)
    , m_load(new IntegerField(this))
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    auto *fields = fieldGrid();
    m_load->setRange(0, canopen::BackgroundPlan::highestLoad);
    prepare(m_load, 5);
    describe(m_load, tr("Load by other devices, in percent"),
             tr("Devices that are no encoders send so much that they take this part of the bus"));
    addCaption(fields, 0, tr("Load by others, %"), m_load);
    fields->addWidget(m_load, 0, 1);
    fields->addWidget(wrongInput(m_load, this), 1, 0, 1, 2);
    column->addLayout(fields);
    m_master =
        addBox(column, tr("Another master"), tr("A master sends SYNC, and asks a device that is no encoder"));
    connect(m_load, &QSpinBox::valueChanged, this, &OtherDevicesBox::setLoad);
    connect(m_master, &QCheckBox::clicked, this, &OtherDevicesBox::setMaster);
}

// A field changes only when the plant has changed, so as not to undo what the user has just typed.
void OtherDevicesBox::showPlant(canopen::SimulatedCanopenPlant &plant)
{
    const canopen::BackgroundPlan now = plant.background();
    if (&plant == m_plant && m_shown == now)
        return;
    m_plant = &plant;
    m_shown = now;
    const QSignalBlocker silent(m_load);
    m_load->setValue(now.load);
    m_master->setChecked(now.hasMaster);
}

void OtherDevicesBox::setLoad(int percent)
{
    canopen::BackgroundPlan plan = m_plant->background();
    plan.load = percent;
    m_plant->setBackground(plan);
    Q_EMIT acted(canAct(CanAct::loadByOthers, {std::int64_t{percent}}));
}

void OtherDevicesBox::setMaster(bool on)
{
    canopen::BackgroundPlan plan = m_plant->background();
    plan.hasMaster = on;
    m_plant->setBackground(plan);
    Q_EMIT acted(canAct(on ? CanAct::masterComes : CanAct::masterGoes));
}

} // namespace codewheel
