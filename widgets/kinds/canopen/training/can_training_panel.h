// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/training/training_area.h"

#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

namespace canopen {
class SimulatedCanopenPlant;
}
class CanEncoderBox;
class CanFaultsBox;
class OtherDevicesBox;
class SimulatedCanAdapter;

// What a trainer can do to a simulated CAN bus: to the bus itself (a place without a node), and to each of
// its encoders, also to one without a number. Used by the training dock.
class CanTrainingPanel final : public TrainingArea
{
    Q_OBJECT

public:
    explicit CanTrainingPanel(BusId bus, QWidget *parent = nullptr);

    // The plant outlives the panel, or is removed first, with the adapter of the program on its bus; null:
    // not a simulated bus.
    void setPlant(canopen::SimulatedCanopenPlant *plant, std::shared_ptr<SimulatedCanAdapter> adapter);
    void refresh() override;

private:
    QString nameOf(Place place) const override;
    void leave() override;
    std::vector<int> numbersNow() const; // by encoder; 0: none
    std::optional<std::size_t> chosenEncoder() const;
    void listEncoders();
    void tell(const TrainingAct &what);

    const BusId m_bus;
    canopen::SimulatedCanopenPlant *m_plant = nullptr;
    std::shared_ptr<SimulatedCanAdapter> m_adapter;
    std::vector<int> m_numbers;    // listed, by encoder
    std::vector<Place> m_encoders; // likewise; of several with one number, each has its own
    CanFaultsBox *m_faults;
    OtherDevicesBox *m_others;
    CanEncoderBox *m_encoder;
};

} // namespace codewheel
