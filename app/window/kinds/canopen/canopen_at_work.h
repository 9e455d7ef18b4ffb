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

    // Ends with opened() or openRefused(); refused like CanLink::open(), in which case the present bus goes
    // on, unless it is at the same adapter.
    void open(const CanopenSettings &settings);
    // The user agrees that watching may acknowledge frames (canWatchNotSure).
    void openUnsure(const CanopenSettings &settings);
    // Refused like canLinkOf().
    Result<std::unique_ptr<CanLink>> makeLink(const CanopenSettings &settings) const;
    // Of the open adapter; usual settings if none is open.
    const CanopenSettings &openedWith() const { return m_openedWith; }
    // Instead of the interfaces and ports of this computer.
    using MakeLink = std::function<std::unique_ptr<CanLink>(const CanLinkArgument &at)>;
    void setMakeLink(MakeLink make) { m_make = std::move(make); }

private:
    void beginTraining(EncoderBus::Start start) override;
    void detach() override { attach(nullptr, {}); }
    void attach(std::shared_ptr<canopen::SimulatedCanopenPlant> training, const CanopenSettings &openedWith);
    void open(const CanopenSettings &settings, bool isUnsure);
    std::unique_ptr<CanopenSession> makeSession(std::unique_ptr<CanLink> link);

    std::shared_ptr<canopen::SimulatedCanopenPlant> m_training;
    CanopenSettings m_openedWith;
    MakeLink m_make;
};

} // namespace codewheel
