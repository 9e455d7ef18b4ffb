// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/wizard/gear_calculator.h"

#include <QGroupBox>

class QLabel;
class QPushButton;

namespace codewheel {

// The calculator: from mm per turn, gear and wanted resolution to steps and revolutions, with the error over
// the range.
class GearPanel : public QGroupBox
{
    Q_OBJECT

public:
    explicit GearPanel(QWidget *parent = nullptr);

    void setLimits(const GearLimits &limits);

Q_SIGNALS:
    void chosen(qint64 steps, qint64 revolutions);

private:
    void calculate();
    void take();

    GearLimits m_limits;
    std::optional<GearResult> m_result;
    DecimalField *m_mmPerTurn = nullptr;
    DecimalField *m_encoderTurns = nullptr;
    DecimalField *m_partTurns = nullptr;
    DecimalField *m_mmPerStep = nullptr;
    QLabel *m_answer;
    QPushButton *m_take;
};

} // namespace codewheel
