// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/simulator/line_training_acts.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "widgets/input/number_fields.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QGridLayout;

namespace codewheel {

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
    struct Rate
    {
        int EscLineFaults::*count;
        QString name;
        QString toolTip;
        LineAct act;
        IntegerField *field = nullptr;
    };

    void makeRates(QGridLayout &grid);
    void setRate(const Rate &rate, int count);
    void setDelay(int milliseconds);
    void setEcho(bool on);
    void setSilent(bool on);
    void setUnplugged(bool on);
    void showFaults(const EscLineFaults &faults);

    SimulatedEscLine *m_line = nullptr;
    std::array<Rate, 4> m_rates;
    IntegerField *m_delay;
    QCheckBox *m_echo = nullptr;
    QCheckBox *m_silent = nullptr;
    QCheckBox *m_unplugged = nullptr;
    std::optional<EscLineFaults> m_shown;
};

} // namespace codewheel
