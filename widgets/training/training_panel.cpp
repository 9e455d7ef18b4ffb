// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/training/training_panel.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/training/fault_plan_bar.h"
#include "widgets/training/ring_faults.h"
#include "widgets/training/rod_controls.h"
#include "widgets/training/shaft_controls.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

using namespace training_fields;

namespace {

constexpr int trainingPanelHeight = 260; // the rest is scrolled to

} // namespace

TrainingPanel::TrainingPanel(TrainingControls &controls, BusId ring, QWidget *parent)
    : QScrollArea(parent)
    , m_controls(controls)
    , m_ring(ring)
    , m_content(new QWidget(this))
    , m_device(describe(new QComboBox(m_content), tr("Device to train with"),
                        tr("The simulated device that is moved, switched and disturbed here")))
    , m_shaft(new ShaftControls(controls, m_content))
    , m_rod(new RodControls(controls, m_content))
    , m_ringFaults(new RingFaults(controls, m_content))
    , m_plan(new FaultPlanBar(controls, m_content))
    , m_writesCaption(new QLabel(tr("EEPROM writes"), m_content))
    , m_writes(numberLabel(tr("EEPROM writes"), m_content))
{
    setAccessibleName(tr("Training"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    auto *column = new QVBoxLayout(m_content);
    column->setContentsMargins(grid::unit, grid::unit, grid::unit, grid::unit);
    column->setSpacing(grid::unit);
    makeTop(column);
    makeTroubles(column);
    column->addWidget(m_ringFaults);
    column->addWidget(m_plan);
    column->addStretch(1);
    setWidget(m_content);

    listDevices();
    connect(m_device, &QComboBox::currentIndexChanged, this, &TrainingPanel::choose);
    connect(m_shaft, &ShaftControls::acted, this, &TrainingPanel::act);
    connect(m_rod, &RodControls::acted, this, &TrainingPanel::act);
    connect(m_ringFaults, &RingFaults::acted, this, &TrainingPanel::act);
    connect(m_plan, &FaultPlanBar::carriedOut, this, [this](NodeId node, const QString &what) {
        Q_EMIT planned({m_ring, node}, what);
    });
    choose();
}

void TrainingPanel::makeTop(QVBoxLayout *column)
{
    auto *device = new QGridLayout;
    device->setHorizontalSpacing(grid::groupGap);
    device->setColumnStretch(1, 1);
    addCaption(device, 0, tr("Device"), m_device);
    device->addWidget(m_device, 0, 1);
    auto *writes = new QGridLayout;
    writes->setColumnStretch(1, 1);
    m_writesCaption->setBuddy(m_writes);
    writes->addWidget(m_writesCaption, 0, 0);
    writes->addWidget(m_writes, 0, 1, Qt::AlignRight);
    column->addLayout(device);
    column->addWidget(m_shaft);
    column->addWidget(m_rod);
    column->addLayout(writes);
}

QPushButton *TrainingPanel::addCommand(QVBoxLayout *column, Icon icon, const QString &text,
                                       const QString &toolTip)
{
    auto *button = new QPushButton(lineIcon(icon), text, m_content);
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
        setFault(TrainingFault::powerOff, !on, on ? tr("Power on.") : tr("Power off."));
    });
    connect(m_slow, &QCheckBox::clicked, this, [this](bool slow) {
        setFault(TrainingFault::slowConfirmation, slow,
                 slow ? tr("Slow confirmation on.") : tr("Slow confirmation off."));
    });
    connect(m_battery, &QCheckBox::clicked, this, [this](bool low) {
        setFault(TrainingFault::batteryLow, low,
                 low ? tr("Battery low; the encoder finds it when it is switched on.")
                     : tr("Battery full; the encoder finds it when it is switched on."));
    });
    connect(m_eeprom, &QCheckBox::clicked, this, [this](bool wornOut) {
        setFault(TrainingFault::eepromWornOut, wornOut,
                 wornOut ? tr("EEPROM worn out.") : tr("EEPROM in order."));
    });
    connect(m_codeDisc, &QCheckBox::clicked, this, [this](bool faulty) {
        setFault(TrainingFault::codeDiscFault, faulty,
                 faulty ? tr("Code disc faulty.") : tr("Code disc in order; run ends the error."));
    });
    connect(m_cycle, &QPushButton::clicked, this, [this] {
        m_controls.powerCycle(m_number->node);
        act(tr("Power off and on."));
    });
    connect(m_lose, &QPushButton::clicked, this,
            [this] { setFault(TrainingFault::parametersLost, true, tr("Parameters lost.")); });
}

void TrainingPanel::listDevices()
{
    const QSignalBlocker silent(m_device);
    m_devices.clear();
    m_device->clear();
    for (const TrainingPlace &place : m_controls.places())
        m_devices.push_back({m_ring, place.number});
    for (const Place number : m_devices)
        m_device->addItem(number.toString());
    m_content->setEnabled(!m_devices.empty());
}

void TrainingPanel::setDevice(Place number)
{
    const auto found = std::ranges::find(m_devices, number);
    if (found != m_devices.end())
        m_device->setCurrentIndex(static_cast<int>(found - m_devices.begin()));
}

void TrainingPanel::choose()
{
    if (m_number) {
        m_shaft->leave();
        m_rod->leave();
    }
    const int index = m_device->currentIndex();
    m_number = index < 0 ? std::nullopt : std::optional(m_devices[static_cast<std::size_t>(index)]);
    m_shown.reset();
    refresh();
}

void TrainingPanel::refresh()
{
    if (!m_number)
        return;
    const std::vector<TrainingControls::Shaft> shafts = m_controls.shafts();
    const auto shaft = std::ranges::find(shafts, m_number->node, &TrainingControls::Shaft::number);
    m_shaft->setVisible(shaft != shafts.end());
    if (shaft != shafts.end()) {
        showCommon({shaft->powered, shaft->hasParameters, shaft->eepromWrites, shaft->hasParameters,
                    shaft->slow, shaft->hasBattery, shaft->batteryLow, shaft->reportsFaults,
                    shaft->eepromWornOut, shaft->codeDiscFaulty});
        m_shaft->showShaft(*shaft);
    }
    const std::vector<TrainingControls::Rod> rods = m_controls.rods();
    const auto rod = std::ranges::find(rods, m_number->node, &TrainingControls::Rod::number);
    m_rod->setVisible(rod != rods.end());
    if (rod != rods.end()) {
        showCommon({.powered = rod->powered, .eepromWrites = rod->eepromWrites});
        m_rod->showRod(*rod);
    }
    if (shaft == shafts.end() && rod == rods.end())
        hideCommon();
    const std::vector<TrainingPlace> places = m_controls.places();
    if (const auto place = std::ranges::find(places, m_number->node, &TrainingPlace::number);
        place != places.end())
        m_ringFaults->showPlace(*place);
    m_plan->refresh();
}

// A field is changed only when the encoder changed: what the user has just ticked is not undone before the
// bus has come round.
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

// A bus terminal: nothing but what befalls the ring.
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

void TrainingPanel::setFault(TrainingFault fault, bool on, const QString &what)
{
    m_controls.setFault(fault, m_number->node, on ? 1 : 0);
    act(what);
}

void TrainingPanel::act(const QString &what)
{
    Q_EMIT acted(*m_number, what);
}

QSize TrainingPanel::sizeHint() const
{
    const QSize content = m_content->sizeHint();
    return {content.width() + verticalScrollBar()->sizeHint().width(),
            std::min(content.height(), trainingPanelHeight)};
}

} // namespace codewheel
