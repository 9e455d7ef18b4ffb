// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/training_act.h"
#include "widgets/input/number_fields.h"
#include "widgets/kinds/interbus/training/shared_controls.h"

#include <QWidget>

#include <map>
#include <optional>

class QCheckBox;
class QVBoxLayout;

namespace codewheel {

// What can happen to the ring at one place: broken wire, missing supply, a wrong device, a peripheral fault,
// CRC errors in its segment. Only what fits the place is shown. Used by the training panel.
class RingFaults : public QWidget
{
    Q_OBJECT

public:
    explicit RingFaults(const SharedControls &controls, QWidget *parent = nullptr);

    void showPlace(const TrainingPlace &place);
    // The panel turns to another device, or to another ring.
    void leave() { m_shown.reset(); }

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    void addBoxFor(QVBoxLayout *column, TrainingFault fault, const QString &toolTip);
    void addRate(QVBoxLayout *column);
    void set(TrainingFault fault, int value);

    const SharedControls &m_controls;
    std::map<TrainingFault, QCheckBox *> m_boxes;
    QWidget *m_rateRow = nullptr;
    IntegerField *m_rate = nullptr; // of 1000 cycles
    std::optional<TrainingPlace> m_shown;
};

} // namespace codewheel
