// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulator/training_controls.h"

#include <QWidget>

#include <map>
#include <optional>

class QCheckBox;
class QSpinBox;
class QVBoxLayout;

namespace codewheel {

// What can happen to the ring at one place: broken wire, missing supply, a wrong device, a peripheral fault,
// CRC errors in its segment. Only what fits the place is shown. Used by the training panel.
class RingFaults : public QWidget
{
    Q_OBJECT

public:
    // The controls outlive it.
    explicit RingFaults(TrainingControls &controls, QWidget *parent = nullptr);

    void showPlace(const TrainingPlace &place);

Q_SIGNALS:
    void acted(const QString &what);

private:
    void addBoxFor(QVBoxLayout *column, TrainingFault fault, const QString &toolTip);
    void addRate(QVBoxLayout *column);
    void set(TrainingFault fault, int value);

    TrainingControls &m_controls;
    std::map<TrainingFault, QCheckBox *> m_boxes;
    QWidget *m_rateRow = nullptr;
    QSpinBox *m_rate = nullptr; // of 1000 cycles
    std::optional<TrainingPlace> m_shown;
};

} // namespace codewheel
