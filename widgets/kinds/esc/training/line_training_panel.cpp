// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/training/line_training_panel.h"

#include "kinds/esc/simulator/simulated_line.h"
#include "widgets/kinds/esc/training/line_encoder_box.h"
#include "widgets/kinds/esc/training/line_faults_box.h"

#include <QVBoxLayout>

namespace codewheel {

LineTrainingPanel::LineTrainingPanel(BusId bus, QWidget *parent)
    : TrainingArea(tr("The simulated line, or the encoder on it, that is moved and disturbed here"), parent)
    , m_bus(bus)
    , m_faults(new LineFaultsBox(content()))
    , m_encoder(new LineEncoderBox(content()))
{
    column()->addWidget(m_faults);
    column()->addWidget(m_encoder);
    endColumn();
    connect(m_faults, &LineFaultsBox::acted, this, &LineTrainingPanel::act);
    connect(m_encoder, &LineEncoderBox::acted, this, &LineTrainingPanel::act);
    setLine(nullptr);
}

void LineTrainingPanel::setLine(SimulatedLine *line)
{
    m_line = line;
    std::vector<Place> devices;
    if (m_line != nullptr) {
        devices.push_back({m_bus, {}});
        for (const LineAddress address : m_line->addresses())
            devices.push_back({m_bus, address.node()});
    }
    setDevices(std::move(devices), tr("Serial line"));
}

void LineTrainingPanel::refresh()
{
    const auto place = chosen();
    m_faults->setVisible(!place || place->isEmpty());
    m_encoder->setVisible(place && !place->isEmpty());
    if (m_line == nullptr || !place)
        return;
    if (place->isEmpty())
        m_faults->showLine(*m_line);
    else
        m_encoder->showEncoder(*m_line, LineAddress::of(place->node));
}

} // namespace codewheel
