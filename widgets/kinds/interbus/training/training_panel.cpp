// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/training/training_panel.h"

#include "widgets/kinds/interbus/training/fault_plan_bar.h"
#include "widgets/kinds/interbus/training/ring_faults.h"
#include "widgets/kinds/interbus/training/rod_controls.h"
#include "widgets/kinds/interbus/training/shaft_controls.h"
#include "widgets/look/icons.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

using namespace training_fields;

TrainingPanel::TrainingPanel(SharedControls controls, BusId ring, QWidget *parent)
    : TrainingArea(tr("The simulated device that is moved, switched and disturbed here"), parent)
    , m_controls(std::move(controls))
    , m_ring(ring)
    , m_shaft(new ShaftControls(m_controls, content()))
    , m_rod(new RodControls(m_controls, content()))
    , m_ringFaults(new RingFaults(m_controls, content()))
    , m_plan(new FaultPlanBar(m_controls, content()))
    , m_writesCaption(new QLabel(tr("EEPROM writes"), content()))
    , m_writes(numberLabel(tr("EEPROM writes"), content()))
{
    makeTop(column());
    makeTroubles(column());
    column()->addWidget(m_ringFaults);
    column()->addWidget(m_plan);
    endColumn();

    connect(m_shaft, &ShaftControls::acted, this, &TrainingPanel::act);
    connect(m_rod, &RodControls::acted, this, &TrainingPanel::act);
    connect(m_ringFaults, &RingFaults::acted, this, &TrainingPanel::act);
    connect(m_plan, &FaultPlanBar::carriedOut, this, [this](NodeId node, const TrainingAct &what) {
        Q_EMIT planned({m_ring, node}, what);
    });
    listDevices();
}

void TrainingPanel::setControls(SharedControls controls)
{
    if (m_controls == controls)
        return;
    leave();
    m_controls = std::move(controls);
    listDevices();
}

void TrainingPanel::listDevices()
{
    std::vector<Place> devices;
    for (const TrainingPlace &place : m_controls->places())
        devices.push_back({m_ring, place.number});
    setDevices(std::move(devices));
}

void TrainingPanel::loadFaultPlan(const QString &path)
{
    m_plan->load(path);
    QMetaObject::invokeMethod( // once it has the room for what it says
        this, [this] { ensureWidgetVisible(m_plan); }, Qt::QueuedConnection);
}

void TrainingPanel::makeTop(QVBoxLayout *column)
{
    auto *writes = new QGridLayout;
    writes->setColumnStretch(1, 1);
    m_writesCaption->setBuddy(m_writes);
    writes->addWidget(m_writesCaption, 0, 0);
    writes->addWidget(m_writes, 0, 1, Qt::AlignRight);
    column->addWidget(m_shaft);
    column->addWidget(m_rod);
    column->addLayout(writes);
}

QPushButton *TrainingPanel::addCommand(QVBoxLayout *column, Icon icon, const QString &text,
                                       const QString &toolTip)
{
    auto *button = new QPushButton(lineIcon(icon), text, content());
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    column->addWidget(button);
    return button;
}

void TrainingPanel::makeTroubles(QVBoxLayout *column)
{
    m_power = addBox(column, tr("Power on"), tr("Supply of the encoder. It forgets what was not activated."));
    m_slow = addBox(column, tr("Slow confirmation"),
                    tr("The encoder takes 50 times as long to confirm a parameter"));
    m_battery = addBox(column, tr("Battery low"), tr("The encoder tests its battery when it is switched on"));
    m_eeprom = addBox(column, tr("EEPROM worn out"), tr("Error 13 when run is to store parameters"));
    m_codeDisc = addBox(column, tr("Code disc faulty"), tr("Error 15, by itself"));
    m_cycle = addCommand(column, Icon::power, tr("Power off and on"),
                         tr("Switch the encoder off and on again after 50 ms"));
    m_lose = addCommand(column, Icon::fault, tr("Lose parameters"),
                        tr("The EEPROM content is destroyed: error 3, until it is parameterized again"));
    connect(m_power, &QCheckBox::clicked, this, [this](bool on) {
        setFault(TrainingFault::powerOff, !on, on ? RingAct::poweredOn : RingAct::poweredOff);
    });
    connect(m_slow, &QCheckBox::clicked, this, [this](bool slow) {
        setFault(TrainingFault::slowConfirmation, slow,
                 slow ? RingAct::slowConfirmationOn : RingAct::slowConfirmationOff);
    });
    connect(m_battery, &QCheckBox::clicked, this, [this](bool low) {
        setFault(TrainingFault::batteryLow, low, low ? RingAct::batteryIsLow : RingAct::batteryIsFull);
    });
    connect(m_eeprom, &QCheckBox::clicked, this, [this](bool wornOut) {
        setFault(TrainingFault::eepromWornOut, wornOut,
                 wornOut ? RingAct::eepromIsWornOut : RingAct::eepromIsInOrder);
    });
    connect(m_codeDisc, &QCheckBox::clicked, this, [this](bool faulty) {
        setFault(TrainingFault::codeDiscFault, faulty,
                 faulty ? RingAct::codeDiscIsFaulty : RingAct::codeDiscIsInOrder);
    });
    connect(m_cycle, &QPushButton::clicked, this, [this] {
        m_controls->powerCycle(chosen()->node);
        act(ringAct(RingAct::powerCycled));
    });
    connect(m_lose, &QPushButton::clicked, this,
            [this] { setFault(TrainingFault::parametersLost, true, RingAct::parametersAreLost); });
}

void TrainingPanel::leave()
{
    m_shaft->leave();
    m_rod->leave();
    m_ringFaults->leave();
    m_shown.reset();
}

void TrainingPanel::refresh()
{
    if (!chosen())
        return;
    const std::vector<TrainingControls::Shaft> shafts = m_controls->shafts();
    const auto shaft = std::ranges::find(shafts, chosen()->node, &TrainingControls::Shaft::number);
    m_shaft->setVisible(shaft != shafts.end());
    if (shaft != shafts.end()) {
        showCommon({shaft->powered, shaft->hasParameters, shaft->eepromWrites, shaft->hasParameters,
                    shaft->slow, shaft->hasBattery, shaft->batteryLow, shaft->reportsFaults,
                    shaft->eepromWornOut, shaft->codeDiscFaulty});
        m_shaft->showShaft(*shaft);
    }
    const std::vector<TrainingControls::Rod> rods = m_controls->rods();
    const auto rod = std::ranges::find(rods, chosen()->node, &TrainingControls::Rod::number);
    m_rod->setVisible(rod != rods.end());
    if (rod != rods.end()) {
        showCommon({.powered = rod->powered, .eepromWrites = rod->eepromWrites});
        m_rod->showRod(*rod);
    }
    if (shaft == shafts.end() && rod == rods.end())
        hideCommon();
    const std::vector<TrainingPlace> places = m_controls->places();
    if (const auto place = std::ranges::find(places, chosen()->node, &TrainingPlace::number);
        place != places.end())
        m_ringFaults->showPlace(*place);
    m_plan->refresh();
}

// A field changes only when the encoder has changed, so as not to undo what the user has just ticked before
// the bus has taken it.
void TrainingPanel::showCommon(const Common &common)
{
    const bool isNew = !m_shown;
    const Common before = std::exchange(m_shown, common).value_or(Common{});
    if (isNew) {
        m_power->setVisible(true);
        m_cycle->setVisible(true);
        m_writesCaption->setVisible(common.hasParameters);
        m_writes->setVisible(common.hasParameters);
        m_slow->setVisible(common.hasConfirmations);
        m_battery->setVisible(common.hasBattery);
        m_eeprom->setVisible(common.reportsFaults);
        m_codeDisc->setVisible(common.reportsFaults);
        m_lose->setVisible(common.hasConfirmations);
    }
    if (isNew || common.eepromWrites != before.eepromWrites)
        m_writes->setText(QLocale().toString(common.eepromWrites));
    if (isNew || common.powered != before.powered)
        m_power->setChecked(common.powered);
    if (isNew || common.slow != before.slow)
        m_slow->setChecked(common.slow);
    if (isNew || common.batteryLow != before.batteryLow)
        m_battery->setChecked(common.batteryLow);
    if (isNew || common.eepromWornOut != before.eepromWornOut)
        m_eeprom->setChecked(common.eepromWornOut);
    if (isNew || common.codeDiscFaulty != before.codeDiscFaulty)
        m_codeDisc->setChecked(common.codeDiscFaulty);
}

// For a bus terminal, only what can happen to the ring.
void TrainingPanel::hideCommon()
{
    m_shown.reset();
    for (QWidget *widget :
         {static_cast<QWidget *>(m_writesCaption), static_cast<QWidget *>(m_writes),
          static_cast<QWidget *>(m_power), static_cast<QWidget *>(m_slow), static_cast<QWidget *>(m_battery),
          static_cast<QWidget *>(m_eeprom), static_cast<QWidget *>(m_codeDisc),
          static_cast<QWidget *>(m_cycle), static_cast<QWidget *>(m_lose)})
        widget->hide();
}

void TrainingPanel::setFault(TrainingFault fault, bool on, RingAct what)
{
    m_controls->setFault(fault, chosen()->node, on ? 1 : 0);
    act(ringAct(what));
}

} // namespace codewheel
