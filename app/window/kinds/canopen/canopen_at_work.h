// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_at_work.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/plan/canopen_plan.h"

#include <QTimer>

#include <functional>
#include <memory>

namespace codewheel {

namespace canopen {
class SimulatedCanopenPlant;
}

// A CAN bus of the program: the simulated one, or one at an interface or a serial adapter.
class CanopenAtWork final : public BusAtWork
{
    Q_OBJECT

public:
    CanopenAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);
    ~CanopenAtWork() override;

    QString kind() const override;
    EncoderBus *bus() const override { return m_session.get(); }
    CanopenSession *session() const { return m_session.get(); }                   // null: none is open
    canopen::SimulatedCanopenPlant *training() const { return m_training.get(); } // null: not simulated

    // Each closes the present bus. The simulated bus begins in Operate, and is connected only when it is
    // asked for: the training plant goes without it.
    void connectTraining();
    // The simulated bus, which is connected, begins anew, in the mode it was in.
    void startAfresh();
    // Begins in Watch, with the encoders of the project and no others. Ends with opened() or openRefused();
    // refused like CanLink::open(), in which case the present bus goes on, unless it is at the same adapter.
    void open(const CanopenSettings &settings);
    // The user agrees that watching may acknowledge frames (canWatchNotSure).
    void openUnsure(const CanopenSettings &settings);
    bool isOpening() const { return m_opening.session != nullptr; }
    // Refused like canLinkOf().
    Result<std::unique_ptr<CanLink>> makeLink(const CanopenSettings &settings) const;
    // Of the open adapter; usual settings if none is open.
    const CanopenSettings &openedWith() const { return m_openedWith; }
    // Instead of the interfaces and ports of this computer.
    using MakeLink = std::function<std::unique_ptr<CanLink>(const CanLinkArgument &at)>;
    void setMakeLink(MakeLink make) { m_make = std::move(make); }
    void close();

Q_SIGNALS:
    void openingChanged();
    void opened();
    void openRefused(const codewheel::Refusal &why);

private:
    // Replaces the present bus once it is open.
    struct Opening
    {
        std::unique_ptr<CanopenSession> session;
        CanopenSettings settings;
        std::optional<Refusal> refusal;
    };

    void followProject();
    void connectTraining(CanopenSession::Start start);
    void open(const CanopenSettings &settings, bool isUnsure);
    std::unique_ptr<CanopenSession> makeSession(std::unique_ptr<CanLink> link);
    void goOnOpening();
    void useOpened(Opening opening);
    void endOpening();
    void replace(std::unique_ptr<CanopenSession> session,
                 std::shared_ptr<canopen::SimulatedCanopenPlant> training, const CanopenSettings &settings);

    std::shared_ptr<canopen::SimulatedCanopenPlant> m_training;
    bool m_gaveWay = false; // the simulated bus, to the project's
    std::unique_ptr<CanopenSession> m_session;
    Opening m_opening;
    QTimer m_openingTurns;
    CanopenSettings m_openedWith;
    MakeLink m_make;
};

} // namespace codewheel
