// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/training/esc_line_training_panel.h"

#include "kinds/esc/simulator/simulated_esc_line.h"
#include "widgets/kinds/esc/training/esc_line_encoder_box.h"
#include "widgets/kinds/esc/training/esc_line_faults_box.h"

#include <QVBoxLayout>

#include <algorithm>

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
    listEncoders();
}

void EscLineTrainingPanel::listEncoders()
{
    m_addresses.clear();
    std::vector<Place> devices;
    if (m_line != nullptr) {
        m_addresses = m_line->addresses();
        devices.push_back({m_bus, {}});
    }
    for (const EscLineAddress address : m_addresses)
        devices.push_back({m_bus, address.node()});
    setDevices(std::move(devices), tr("Serial line"));
}

// An encoder that has another address now is still the one that was chosen.
void EscLineTrainingPanel::followAddresses()
{
    const auto before = chosen();
    const auto found = std::ranges::find_if(m_addresses, [&](EscLineAddress address) {
        return before == Place{m_bus, address.node()};
    });
    const auto encoder = static_cast<std::size_t>(found - m_addresses.begin());
    listEncoders();
    if (encoder < m_addresses.size())
        setDevice({m_bus, m_addresses[encoder].node()});
}

void EscLineTrainingPanel::refresh()
{
    if (m_line != nullptr && m_line->addresses() != m_addresses)
        followAddresses();
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
