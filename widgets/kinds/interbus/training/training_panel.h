// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/ring_training_acts.h"
#include "widgets/kinds/interbus/training/shared_controls.h"
#include "widgets/look/icons.h"
#include "widgets/training/training_area.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace codewheel {

class FaultPlanBar;
class RingFaults;
class RodControls;
class ShaftControls;

// What a trainer can do to the simulated encoders of a ring: turn a shaft or move a magnet, switch the power,
// cause faults. Shows only what a device has. Used by the training dock.
class TrainingPanel final : public TrainingArea
{
    Q_OBJECT

public:
    explicit TrainingPanel(SharedControls controls, BusId ring = firstBus, QWidget *parent = nullptr);

    // Another ring from now on: the device stays chosen, and a loaded fault plan stays loaded.
    void setControls(SharedControls controls);
    void refresh() override;
    void loadFaultPlan(const QString &path); // the panel says what is wrong with it

Q_SIGNALS:
    void planned(codewheel::Place number, const codewheel::TrainingAct &what); // by the fault plan

private:
    // What a shaft and a rod have in common.
    struct Common
    {
        bool powered = true;
        bool hasParameters = true;
        int eepromWrites = 0;
        bool hasConfirmations = false; // whose time can be changed
        bool slow = false;
        bool hasBattery = false;
        bool batteryLow = false;
        bool reportsFaults = false; // of its EEPROM and its code disc
        bool eepromWornOut = false;
        bool codeDiscFaulty = false;
    };

    void listDevices();
    void makeTop(QVBoxLayout *column);
    void makeTroubles(QVBoxLayout *column);
    QPushButton *addCommand(QVBoxLayout *column, Icon icon, const QString &text, const QString &toolTip);
    void leave() override;
    void showCommon(const Common &common);
    void hideCommon();
    void setFault(TrainingFault fault, bool on, RingAct what);

    SharedControls m_controls;
    const BusId m_ring;
    std::optional<Common> m_shown; // shown by the fields

    ShaftControls *m_shaft;
    RodControls *m_rod;
    RingFaults *m_ringFaults;
    FaultPlanBar *m_plan;
    QLabel *m_writesCaption;
    QLabel *m_writes;
    QCheckBox *m_power = nullptr;
    QPushButton *m_cycle = nullptr;
    QCheckBox *m_slow = nullptr;
    QCheckBox *m_battery = nullptr;
    QCheckBox *m_eeprom = nullptr;
    QCheckBox *m_codeDisc = nullptr;
    QPushButton *m_lose = nullptr;
};

} // namespace codewheel
