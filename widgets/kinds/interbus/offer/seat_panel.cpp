// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/seat_panel.h"

#include "widgets/kinds/interbus/training/training_panel.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"

#include <QLabel>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int narrowest = 52 * grid::unit; // as a dock

} // namespace

SeatPanel::SeatPanel(QWidget *parent)
    : QWidget(parent)
    , m_seat(named(new QLabel(this), "seatTreated"))
    , m_column(layOut<QVBoxLayout>(this, grid::unit))
{
    m_seat->setFont(textFont(TextSize::large));
    m_column->addWidget(m_seat);
    hide();
}

void SeatPanel::makePanel(BusId ring, const SharedControls &controls)
{
    m_panel = new TrainingPanel(controls, ring, this);
    connect(m_panel, &TrainingPanel::acted, this, [this](Place place, const TrainingAct &what) {
        if (m_unit)
            Q_EMIT acted(*m_unit, place, what);
    });
    m_column->addWidget(m_panel, 1);
    onEventOf(m_panel->widget(), {QEvent::LayoutRequest}, this, [this] { fitWidth(); });
    fitWidth();
}

// Its controls need more for another device, or are larger now. It never becomes narrower, so that the table
// beside it stays as it is.
void SeatPanel::fitWidth()
{
    setFixedWidth(std::max({narrowest, minimumWidth(), m_panel->sizeHint().width()}));
}

// What was done last is still told of the seat before.
void SeatPanel::showSeat(int unit, BusId ring, const SharedControls &controls)
{
    if (m_panel == nullptr)
        makePanel(ring, controls);
    m_panel->setControls(controls);
    if (m_unit != unit) {
        m_unit = unit;
        m_seat->setText(tr("Seat %1").arg(unit));
    }
    m_panel->refresh();
    setVisible(true);
}

void SeatPanel::leave()
{
    m_unit.reset();
    hide();
}

} // namespace codewheel
