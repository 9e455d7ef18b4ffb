// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulator/training_controls.h"

#include <QScrollArea>

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QSpinBox;
class QVBoxLayout;

namespace codewheel {

class HandWheel;

// What a trainer does to the simulated encoders: turn a shaft, switch the power, cause faults. Used by the
// training dock.
class TrainingPanel : public QScrollArea
{
    Q_OBJECT

public:
    // The controls outlive the panel.
    explicit TrainingPanel(TrainingControls &controls, QWidget *parent = nullptr);

    // Chooses this device, if it is one of the simulated ring.
    void setDevice(DeviceNumber number);
    // Shows how the encoder stands; called by the window with every picture.
    void refresh();

    QSize sizeHint() const override;

Q_SIGNALS:
    void acted(codewheel::DeviceNumber number, const QString &what);

private:
    using Shaft = TrainingControls::Shaft;

    void makeShaft(QVBoxLayout *column);
    void makePosition(QGridLayout *grid);
    void makeSpeed(QGridLayout *grid);
    void makeTroubles(QVBoxLayout *column);
    QCheckBox *addBox(QVBoxLayout *column, const QString &text, const QString &toolTip);
    void listDevices(const std::vector<Shaft> &shafts);
    void choose();
    void showShaft(const Shaft &shaft);
    void showPosition(const Shaft &shaft);
    void turnBy(qint64 steps);
    void turnTo();
    void setSpeed(double rpm);
    void setPower(bool on);
    void tellOfTurning();
    void act(const QString &what);

    TrainingControls &m_controls;
    std::optional<Shaft> m_shown; // what the fields say of the encoder
    int m_picturesToRest = 0;     // pictures until a turn by hand is told of

    QWidget *m_content;
    QComboBox *m_device;
    HandWheel *m_wheel;
    QLabel *m_raw;
    QLabel *m_turn;
    QLabel *m_writes;
    QSpinBox *m_target;
    QDoubleSpinBox *m_speed;
    QCheckBox *m_power = nullptr;
    QCheckBox *m_slow = nullptr;
    QCheckBox *m_battery = nullptr;
};

} // namespace codewheel
