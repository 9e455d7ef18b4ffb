// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_at_work.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/line/esc_line_settings.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "links/serial_port_link.h"

#include <QTimer>

#include <memory>

namespace codewheel {

// A serial line of the program: the simulated one of the training bus, or one at a port.
class EscLineAtWork final : public BusAtWork
{
    Q_OBJECT

public:
    EscLineAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);
    ~EscLineAtWork() override;

    QString kind() const override;
    EncoderBus *bus() const override { return m_session.get(); }
    EscLineSession *session() const { return m_session.get(); }     // null: none is open
    SimulatedEscLine *training() const { return m_training.get(); } // null: it is no training line

    // Each closes the present line. The training line begins in Operate.
    void openTraining() override;
    // The training line, which is connected, begins anew, in the mode it was in.
    void startAfresh();
    // Begins in Watch, with the encoders of the project and no others, at its adapter wherever that is
    // plugged in. Ends with portOpened() or openRefused(); refused like ByteLink::open(), in which case the
    // present line goes on, unless it is at the same port.
    void openPort(const EscLinePlan &line);
    // The same again, with the adapter that was refused (portOfOther) instead of the line's own.
    void openOtherAdapter(const EscLinePlan &line);
    // To a line as planned, for testing it.
    std::unique_ptr<ByteLink> makeLink(const EscLinePlan &line) const;
    bool isOpening() const { return m_opening.session != nullptr; } // a port
    // With the port and adapter now open: the adapter may have been moved, or another one chosen, meanwhile.
    EscLinePlan asOpened(EscLinePlan line) const;
    // The open port, without its encoders, and how it was opened; factory settings if none is open.
    EscLinePlan opened() const;
    // Instead of this computer's ports.
    void setPortList(SerialPortLink::PortList ports) { m_ports = std::move(ports); }
    std::vector<PortInfo> ports() const { return m_ports(); }
    void close();

Q_SIGNALS:
    void openingChanged();
    void portOpened();
    void openRefused(const codewheel::Refusal &why);

private:
    // Replaces the present line once it is open.
    struct Opening
    {
        std::unique_ptr<EscLineSession> session;
        const SerialPortLink *port = nullptr;
        EscLineSettings wish;
        std::optional<Refusal> refusal;
    };

    void followProject();
    void openTraining(EscLineSession::Start start);
    void tellByteOrder();
    std::unique_ptr<EscLineSession> makeSession(std::unique_ptr<ByteLink> link, const EscLineSettings &wish);
    void open(const EscLinePlan &line); // at m_wanted
    void goOnOpening();
    void useOpened(Opening opening);
    void endOpening();
    bool holds(const QString &path) const;
    void replace(std::unique_ptr<EscLineSession> session, std::shared_ptr<SimulatedEscLine> training,
                 const SerialPortLink *port);

    std::shared_ptr<SimulatedEscLine> m_training;
    bool m_gaveWay = false; // the training line, to a project's line
    std::unique_ptr<EscLineSession> m_session;
    Opening m_opening;
    QTimer m_openingTurns;
    const SerialPortLink *m_port = nullptr; // of the session; null: not at a port
    EscLineSettings m_openedWith;           // the port
    std::optional<KeptAdapter> m_wanted;    // when a port was last to be opened
    SerialPortLink::PortList m_ports = serialPorts;
};

} // namespace codewheel
