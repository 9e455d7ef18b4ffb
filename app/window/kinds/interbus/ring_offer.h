// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/kinds/interbus/offered_rings.h"
#include "kinds/interbus/gateway/served_news.h"
#include "kinds/interbus/links/modbus_tcp_server.h"
#include "kinds/interbus/simulator/fault_plan_news.h"
#include "vocabulary/training_act.h"
#include "widgets/kinds/interbus/offer/offer_wish.h"
#include "widgets/kinds/interbus/offer/offered_view.h"
#include "widgets/kinds/interbus/offer/seats_model.h"

#include <QObject>

#include <optional>

namespace codewheel {

class Catalog;
class RingAtWork;
struct Project;

// The devices of a ring, with their names and registers.
std::vector<ServedDevice> servedDevices(const RingStructure &ring, const Catalog &catalog);

// A simulated ring offered to others by Modbus/TCP: the ring of the window, or one for each seat of a class.
// Belongs to its RingAtWork, so it outlives the window; never begins by itself. It ends when what is offered
// is no longer there: clients are answered with exception 4, then disconnected.
class RingOffer : public QObject
{
    Q_OBJECT

public:
    explicit RingOffer(RingAtWork &ring);
    ~RingOffer() override;

    // Why it cannot be offered, however it is wanted; empty: it can.
    std::optional<Refusal> whyNot() const;
    // Refused: as whyNot(), closedRingNotOffered, or as ModbusTcpServer::start().
    Result<void> begin(const OfferWish &wish);
    void end();
    bool isOn() const { return m_server != nullptr; }
    int connectedClients() const; // 0 while it is off
    // What they lose with it, in sentences; empty: nobody is connected.
    QString endsForClients() const;

    // While it is on.
    OfferedPlace place() const;
    ServerPlace server() const { return m_server->place(); }
    std::vector<ServedClient> clients() const { return m_server->clients().clients(); }
    ClientCounts counts() const { return m_server->clients().counts(); }
    std::vector<Seat> seats(std::optional<NodeId> device) const; // with the words of this device
    std::vector<ServedDevice> devices() const;                   // of one of the rings: they are alike
    void restart(int unit);                                      // the ring of a seat
    // Whom that concerns, in words; empty: nobody is connected there, or has written to it.
    QString restartsForClients(int unit) const;
    // What a trainer can do to the ring of a seat; another one after restart(). Null: there is no such seat.
    std::shared_ptr<TrainingControls> controls(int unit) const;
    // What was done to the ring of a seat, for the messages.
    void tellOfSeat(int unit, NodeId node, const TrainingAct &what, MessageCode id = MessageId::training);
    // For a client of the seat, or of the one ring (unit 1): this ring behind a gateway that is reached at
    // `host`.
    Project clientProject(int unit, const QString &host) const;
    // The ring of the window starts afresh. It stays offered, unless its words are in other registers then.
    void goOnWith(const RingStructure &afresh);

    // With each frame of the window: what has happened since the last one.
    void takeFrame();

Q_SIGNALS:
    void changed(); // it is on, or no longer
    void messaged(const codewheel::Message &message);

private:
    bool offersWindowsRing() const { return isOn() && !m_wish.hasSeats; }
    RingSession &offeredRing() const; // one of them: they are alike
    void takePlans();
    void endAs(MessageCode why);
    void stop();
    void tell(Message message);
    void followBus();

    RingAtWork &m_ring;
    OfferWish m_wish;
    std::shared_ptr<RingGuests> m_guests; // of the window's ring
    OfferedRings m_seats;
    std::vector<FaultPlanNews> m_plans; // of the seats
    ServedNews m_news;
    std::unique_ptr<ModbusTcpServer> m_server; // ends first
};

} // namespace codewheel
