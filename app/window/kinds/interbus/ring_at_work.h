// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/kinds/interbus/training_session.h"
#include "app/window/buses/bus_at_work.h"
#include "journal/ledger.h"
#include "kinds/interbus/gateway/gateway_link.h"

#include <functional>

namespace codewheel {

class RingOffer;

// A ring of the program: a training ring, the same at each start, or a real one behind a gateway, as the
// project plans its link.
class RingAtWork final : public BusAtWork
{
    Q_OBJECT

public:
    using MakeTraining = TrainingBus (*)(const Catalog &); // Surroundings::training
    using MakePort = std::function<std::unique_ptr<RegisterPort>(const GatewaySettings &)>;

    RingAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);
    ~RingAtWork() override;

    QString kind() const override;
    RingSession *bus() const override { return m_training.bus.get(); }
    TrainingControls &controls() const { return *m_training.controls; }
    std::shared_ptr<TrainingControls> sharedControls() const { return m_training.controls; }
    // The gateway it is connected to, or was last; empty: it is a training ring.
    const std::optional<GatewaySettings> &gateway() const { return m_gateway; }

    // Connects it by the link that the project plans: a training ring in Operate, a real one in Watch. How it
    // ends is reported by the bus. Refused (linkSettingWrong): the plan is not understood.
    Result<void> open();
    void openTraining() override; // and plans it as it is: nothing differs at first
    // The simulated ring, which is connected, begins anew: a new one takes its place, in the mode it was in.
    void startAfresh();
    bool isStartingAfresh() const { return m_isStartingAfresh; } // the old one is leaving, the new one comes
    std::optional<Place> turning() const override;
    QString endsForOthers() const override;
    void start() override;
    RingOffer &offer() { return *m_offer; } // to others
    // Another training ring, with the devices that the project plans here.
    TrainingSession makeSeat() const;
    // Instead of the registers of a real gateway.
    void setPorts(MakePort makePort) { m_makePort = std::move(makePort); }
    std::unique_ptr<RegisterPort> makePort(const GatewaySettings &settings) const
    {
        return m_makePort(settings);
    }

Q_SIGNALS:
    void linkChanged(); // to or from a training ring, to a new one, or another gateway

private:
    void followProject();
    void tellPlan();
    void useTraining();
    void useGateway(const GatewaySettings &settings);
    void use(std::unique_ptr<ProcessDataLink> link);
    void keepAccountOfLink();
    Result<void> openLink(RingSession::Start start);

    // Of the writes to the encoders of the training ring.
    struct AccountInMemory
    {
        DatabasePlace place = DatabasePlace::memory();
        Stored<Ledger> keptOpen = Ledger::open(place); // while another ring is connected
    };

    AccountInMemory m_trainingAccount; // as old as the encoders
    TrainingSession m_training;
    std::unique_ptr<ProcessDataLink> m_trainingLink; // while a gateway is in use
    std::optional<GatewaySettings> m_gateway;
    MakePort m_makePort;
    bool m_planIsTold = false;
    bool m_isStartingAfresh = false;
    std::unique_ptr<RingOffer> m_offer; // nobody uses the ring any more when it goes
};

} // namespace codewheel
