// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/training/esc_line_training_panel.h"

#include "kinds/esc/simulator/simulated_esc_line.h"
#include "widgets/kinds/esc/training/esc_line_encoder_box.h"
#include "widgets/kinds/esc/training/esc_line_faults_box.h"

#include <QVBoxLayout>

namespace codewheel {

EscLineTrainingPanel::EscLineTrainingPanel(BusId bus, QWidget *parent)
    : TrainingArea(tr("The simulated line, or the encoder on it, that is moved and disturbed here"), parent)
    , m_bus(bus)
    , m_faults(new EscLineFaultsBox(content()))
    , m_encoder(new EscEncoderBox(content()))
{
    column()->addWidget(m_faults);
    column()->addWidget(m_encoder);
    endColumn();
    connect(m_faults, &EscLineFaultsBox::acted, this, &EscLineTrainingPanel::act);
    connect(m_encoder, &EscEncoderBox::acted, this, &EscLineTrainingPanel::act);
    setLine(nullptr);
}

void EscLineTrainingPanel::setLine(SimulatedEscLine *line)
{
    m_line = line;
    std::vector<Place> devices;
    if (m_line != nullptr) {
        devices.push_back({m_bus, {}});
        for (const EscLineAddress address : m_line->addresses())
            devices.push_back({m_bus, address.node()});
    }
    setDevices(std::move(devices), tr("Serial line"));
}

void EscLineTrainingPanel::refresh()
{
    const auto place = chosen();
    m_faults->setVisible(!place || place->isEmpty());
    m_encoder->setVisible(place && !place->isEmpty());
    if (m_line == nullptr || !place)
        return;
    if (place->isEmpty())
        m_faults->showLine(*m_line);
    else
        m_encoder->showEncoder(*m_line, EscLineAddress::of(place->node));
}

} // namespace codewheel
