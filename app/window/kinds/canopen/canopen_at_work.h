// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_at_work.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/plan/canopen_plan.h"

#include <functional>
#include <memory>

namespace codewheel {

namespace canopen {
class SimulatedCanopenPlant;
}
class SimulatedCanAdapter;

// A CAN bus of the program: the simulated one, or one at an interface or a serial adapter. The simulated bus
// is connected only when it is asked for: the training plant goes without it.
class CanopenAtWork final : public AskedBusAtWork
{
    Q_OBJECT

public:
    CanopenAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);

    QString kind() const override;
    CanopenSession *session() const { return static_cast<CanopenSession *>(present()); } // null: none is open
    canopen::SimulatedCanopenPlant *training() const { return m_training.get(); } // null: not simulated
    const std::shared_ptr<SimulatedCanAdapter> &trainingAdapter() const { return m_trainingAdapter; } // to it

    // Refused like canLinkOf().
    Result<std::unique_ptr<CanLink>> makeLink(const CanopenSettings &settings) const;
    // Instead of the interfaces and ports of this computer.
    using MakeLink = std::function<std::unique_ptr<CanLink>(const CanLinkArgument &at)>;
    void setMakeLink(MakeLink make) { m_make = std::move(make); }

private:
    void beginTraining(EncoderBus::Start start) override;
    // Agreed: watching may acknowledge frames (CanRefusalId::watchNotSure).
    void beginOpening(const KindData &plan, bool isAgreed) override;
    void detach() override
    {
        m_training.reset();
        m_trainingAdapter.reset();
    }
    std::unique_ptr<CanopenSession> makeSession(std::unique_ptr<CanLink> link);

    std::shared_ptr<canopen::SimulatedCanopenPlant> m_training;
    std::shared_ptr<SimulatedCanAdapter> m_trainingAdapter; // null: not simulated
    MakeLink m_make;
};

} // namespace codewheel
