// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/wizard/rod_calculator.h"

#include <QGroupBox>

class QLabel;
class QPushButton;

namespace codewheel {

// Calculates the measuring length in steps from the length of the rod and the wanted resolution, and says how
// far off the end will be.
class RodPanel : public QGroupBox
{
    Q_OBJECT

public:
    explicit RodPanel(QWidget *parent = nullptr);

    void setRodLength(double millimetres); // as known
    double rodLength() const;
    void setMostSteps(std::int64_t most);

Q_SIGNALS:
    void chosen(qint64 steps);

private:
    void calculate();
    void take();

    DecimalField *m_length;
    DecimalField *m_mmPerStep;
    QLabel *m_answer;
    QPushButton *m_take;
    std::int64_t m_most = 0;
    std::optional<RodResult> m_result;
};

} // namespace codewheel
