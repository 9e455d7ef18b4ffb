// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/training_session.h"
#include "app/window/bus_at_work.h"

namespace codewheel {

// A ring of the program: a training ring, the same at each start.
class RingAtWork final : public BusAtWork
{
    Q_OBJECT

public:
    using MakeTraining = TrainingBus (*)(const Catalog &); // Surroundings::training

    RingAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);
    ~RingAtWork() override;

    QString kind() const override;
    RingSession *bus() const override { return m_training.bus.get(); }
    TrainingControls &controls() const { return *m_training.controls; }

    // How its thread is paced; nothing: it is driven by hand.
    std::optional<Pacing> pacing() const;
    // Connects it in Operate, like RingSession::open().
    Result<void> open(std::optional<Pacing> pacing);
    void openTraining() override; // and plans it as it is: nothing differs at first
    std::optional<Place> turning() const override;
    void start() override;

private:
    void tellPlan();

    TrainingSession m_training;
    bool m_planIsTold = false;
};

} // namespace codewheel
