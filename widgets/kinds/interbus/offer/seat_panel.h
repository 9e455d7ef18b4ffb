// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "vocabulary/training_act.h"
#include "widgets/kinds/interbus/training/shared_controls.h"

#include <QWidget>

#include <optional>

class QLabel;
class QVBoxLayout;

namespace codewheel {

class TrainingPanel;

// What a trainer can do to the ring of one seat: as with the panel Training, beside the table of the seats.
// Hidden while no seat is chosen.
class SeatPanel : public QWidget
{
    Q_OBJECT

public:
    explicit SeatPanel(QWidget *parent = nullptr);

    // Frame by frame: a seat that starts afresh has other controls.
    void showSeat(int unit, BusId ring, const SharedControls &controls);
    void leave(); // no seat is chosen

Q_SIGNALS:
    void acted(int unit, codewheel::Place place, const codewheel::TrainingAct &what);

private:
    void makePanel(BusId ring, const SharedControls &controls);
    void fitWidth();

    std::optional<int> m_unit;
    QLabel *m_seat;
    TrainingPanel *m_panel = nullptr; // from the first seat on
    QVBoxLayout *m_column;
};

} // namespace codewheel
