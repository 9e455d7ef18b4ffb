// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/training/can_training_panel.h"

#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "widgets/kinds/canopen/training/can_encoder_box.h"
#include "widgets/kinds/canopen/training/can_faults_box.h"
#include "widgets/kinds/canopen/training/other_devices_box.h"

#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

// "can:5", and of another one with this number "can:5#2".
NodeId entryOf(int number, std::ptrdiff_t before)
{
    const NodeId place = CanopenAddress{number}.place();
    return before == 0 ? place : NodeId(std::string(place.text()) + '#' + std::to_string(before + 1));
}

} // namespace

CanTrainingPanel::CanTrainingPanel(BusId bus, QWidget *parent)
    : TrainingArea(tr("The simulated bus, or the encoder on it, that is moved and disturbed here"), parent)
    , m_bus(bus)
    , m_faults(new CanFaultsBox(content()))
    , m_others(new OtherDevicesBox(content()))
    , m_encoder(new CanEncoderBox(content()))
{
    column()->addWidget(m_faults);
    column()->addWidget(m_others);
    column()->addWidget(m_encoder);
    endColumn();
    connect(m_faults, &CanFaultsBox::acted, this, &CanTrainingPanel::tell);
    connect(m_others, &OtherDevicesBox::acted, this, &CanTrainingPanel::tell);
    connect(m_encoder, &CanEncoderBox::acted, this, &CanTrainingPanel::tell);
    setPlant(nullptr, {});
}

void CanTrainingPanel::setPlant(canopen::SimulatedCanopenPlant *plant,
                                std::shared_ptr<SimulatedCanAdapter> adapter)
{
    leave();
    m_plant = plant;
    m_adapter = std::move(adapter);
    listEncoders();
}

std::vector<int> CanTrainingPanel::numbersNow() const
{
    std::vector<int> numbers;
    for (std::size_t which = 0; m_plant != nullptr && which < m_plant->count(); ++which)
        numbers.push_back(m_plant->withEncoder(
            which, [](const canopen::SimulatedNode &node) { return node.plannedNode().value_or(0); }));
    return numbers;
}

void CanTrainingPanel::listEncoders()
{
    m_numbers = numbersNow();
    m_encoders.clear();
    for (auto number = m_numbers.begin(); number != m_numbers.end(); ++number)
        m_encoders.push_back({m_bus, entryOf(*number, std::count(m_numbers.begin(), number, *number))});
    std::vector<Place> devices = m_encoders;
    if (m_plant != nullptr)
        devices.insert(devices.begin(), Place{m_bus, {}});
    setDevices(std::move(devices), tr("CAN bus"));
}

QString CanTrainingPanel::nameOf(Place place) const
{
    const QString entry = place.toString();
    const QString without = QString::fromLatin1(CanopenAddress{}.place().text().data());
    return entry.startsWith(without) ? tr("Without a number") + entry.sliced(without.size()) : entry;
}

std::optional<std::size_t> CanTrainingPanel::chosenEncoder() const
{
    const auto place = chosen();
    const auto found = place ? std::ranges::find(m_encoders, *place) : m_encoders.end();
    return found == m_encoders.end() ? std::nullopt
                                     : std::optional(static_cast<std::size_t>(found - m_encoders.begin()));
}

// An encoder that has another number now is still the one that was chosen.
void CanTrainingPanel::refresh()
{
    if (m_plant != nullptr && numbersNow() != m_numbers) {
        const auto encoder = chosenEncoder();
        listEncoders();
        if (encoder)
            setDevice(m_encoders.at(*encoder));
    }
    const auto encoder = chosenEncoder();
    m_faults->setVisible(!encoder);
    m_others->setVisible(!encoder);
    m_encoder->setVisible(encoder.has_value());
    if (m_plant == nullptr || !chosen())
        return;
    if (encoder) {
        m_encoder->showEncoder(*m_plant, *encoder);
        return;
    }
    m_faults->showBus(*m_plant, m_adapter);
    m_others->showPlant(*m_plant);
}

void CanTrainingPanel::leave()
{
    m_encoder->leave();
}

// What has no number has no place of its own.
void CanTrainingPanel::tell(const TrainingAct &what)
{
    const auto encoder = chosenEncoder();
    const int number = encoder ? m_numbers.at(*encoder) : 0;
    Q_EMIT acted({m_bus, number != 0 ? CanopenAddress{number}.place() : NodeId()}, what);
}

} // namespace codewheel
