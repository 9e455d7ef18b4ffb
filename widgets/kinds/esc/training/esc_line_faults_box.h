// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/simulator/line_training_acts.h"
#include "kinds/esc/simulator/simulated_esc_line.h"

#include <QWidget>

#include <optional>

class QCheckBox;

namespace codewheel {

class RateFields;

// What can happen to the simulated serial line: bytes lost, wrong, doubled or late, an adapter that hears its
// own echo, encoders that fall silent, an adapter that is unplugged. Part of the training panel.
class EscLineFaultsBox : public QWidget
{
    Q_OBJECT

public:
    explicit EscLineFaultsBox(QWidget *parent = nullptr);

    // With each frame; the line outlives it, or another one is shown first.
    void showLine(SimulatedEscLine &line);

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    void setRate(std::size_t row, int count);
    void setDelay(int milliseconds);
    void setEcho(bool on);
    void setSilent(bool on);
    void setUnplugged(bool on);
    void showFaults(const EscLineFaults &faults);

    SimulatedEscLine *m_line = nullptr;
    RateFields *m_rates;
    QCheckBox *m_echo = nullptr;
    QCheckBox *m_silent = nullptr;
    QCheckBox *m_unplugged = nullptr;
    std::optional<EscLineFaults> m_shown;
};

} // namespace codewheel
