// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_at_work.h"
#include "bus/asked_bus.h"
#include "links/serial_ports.h"
#include "vocabulary/kind_data.h"

#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace codewheel {

// A bus of the program whose encoders are asked one by one: the simulated one of the training bus, or one at
// an adapter, which is opened in a thread of its own, since it may be slow. Until it is open the present bus
// goes on.
class AskedBusAtWork : public BusAtWork
{
    Q_OBJECT

public:
    AskedBusAtWork(BusId id, Surroundings surroundings, QObject *parent);
    ~AskedBusAtWork() override;

    EncoderBus *bus() const override { return m_session.get(); }
    bool isSimulatedHere() const { return m_isSimulated; } // the bus that is there now
    bool isOpening() const { return m_opening != nullptr; }

    // Each closes the present bus. The simulated one begins in Operate.
    void connectTraining() { simulate(EncoderBus::Start::operating); }
    // The simulated one, which is connected, begins anew, in the mode it was in.
    void startAfresh();
    void close();

    // At the link of a plan of its kind. Ends with opened() or openRefused(); refused like its link, in which
    // case the present bus goes on, unless it is at the same adapter.
    void open(const KindData &plan);
    // The same again, once the user agrees to what it was refused for.
    void openAgreed(const KindData &plan);
    const KindData &openedWith() const { return m_openedWith; } // empty: not by open()
    // Where its link is now: an adapter may have been moved, or another one chosen, since it was planned.
    virtual KindData asOpened(const KindData &plan) const { return plan; }
    KindData openedPlan() const; // as it is open, or else the usual one
    virtual std::vector<PortInfo> ports() const { return serialPorts(); } // where an adapter may be

Q_SIGNALS:
    void openingChanged();
    void opened();
    void openRefused(const codewheel::Refusal &why); // the present bus goes on

protected:
    using Attach = std::function<void()>; // notes what of the kind belongs to the bus from now on

    AskedBus *present() const { return m_session.get(); }
    EncoderBus::Drive drive() const; // of a simulated bus
    void replace(std::unique_ptr<AskedBus> session, bool isSimulated, const Attach &attach);
    // Its opening has begun; it begins in Watch, with the encoders of the project and no others.
    void waitUntilOpen(std::unique_ptr<AskedBus> session, const KindData &plan, const Attach &attach);

private:
    virtual void beginTraining(EncoderBus::Start start) = 0; // ends with replace()
    // Ends with waitUntilOpen() or openRefused().
    virtual void beginOpening(const KindData &plan, bool isAgreed) = 0;
    virtual void detach() = 0; // nothing of the kind belongs to a bus any more

    void simulate(EncoderBus::Start start);
    void endOpening();
    void followProject();
    void goOnOpening();

    std::unique_ptr<AskedBus> m_session;
    bool m_isSimulated = false;
    KindData m_openedWith;
    bool m_gaveWay = false; // the simulated bus, to that of a project
    std::unique_ptr<AskedBus> m_opening;
    Attach m_attach; // of the one that is opening
    std::optional<Refusal> m_refusal;
    QTimer m_openingTurns;
};

Instant steadyTime(); // that a simulated bus in a thread of its own goes by

} // namespace codewheel
