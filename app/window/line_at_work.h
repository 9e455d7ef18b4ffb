// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/bus_at_work.h"
#include "esc_line/line_session.h"
#include "esc_line/line_settings.h"
#include "links/serial_port_link.h"
#include "project/line_plan.h"
#include "simulator/simulated_line.h"

#include <QTimer>

#include <memory>

namespace codewheel {

// A serial line of the program: the simulated one of the training bus, or one at a port.
class LineAtWork final : public BusAtWork
{
    Q_OBJECT

public:
    LineAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);
    ~LineAtWork() override;

    QString kind() const override;
    EncoderBus *bus() const override { return m_session.get(); }
    LineSession *session() const { return m_session.get(); }     // null: none is open
    SimulatedLine *training() const { return m_training.get(); } // null: it is no training line

    // Each ends the line there was. The training line begins in Operate.
    void openTraining() override;
    // Begins in Watch, with the encoders of the project and no others, at its adapter wherever that is
    // plugged in. portOpened() or openRefused() tells the end of it; refused as ByteLink::open(), the line
    // there was goes on, unless it was at the same port.
    void openPort(const LinePlan &line);
    // The same once more, with the adapter that it refused (portOfOther) in place of that of the line.
    void openOtherAdapter(const LinePlan &line);
    bool isOpening() const { return m_opening.session != nullptr; } // a port
    // With the port and the adapter that are open: it may be plugged in elsewhere, or another one be meant
    // meanwhile.
    LinePlan asOpened(LinePlan line) const;
    // The port that is open, without its encoders, and how it was opened; as the factory has it where none
    // is.
    LinePlan opened() const;
    // In place of those of this computer.
    void setPortList(SerialPortLink::PortList ports) { m_ports = std::move(ports); }
    std::vector<PortInfo> ports() const { return m_ports(); }
    void close();

Q_SIGNALS:
    void openingChanged();
    void portOpened();
    void openRefused(const codewheel::Refusal &why);

private:
    // It takes the place of the line there is once it is open.
    struct Opening
    {
        std::unique_ptr<LineSession> session;
        const SerialPortLink *port = nullptr;
        LineSettings wish;
        std::optional<Refusal> refusal;
    };

    void followProject();
    void tellByteOrder();
    std::unique_ptr<LineSession> makeSession(std::unique_ptr<ByteLink> link, const LineSettings &wish);
    void open(const LinePlan &line); // at m_wanted
    void goOnOpening();
    void useOpened(Opening opening);
    void endOpening();
    bool holds(const QString &path) const;
    void replace(std::unique_ptr<LineSession> session, std::shared_ptr<SimulatedLine> training,
                 const SerialPortLink *port);

    std::shared_ptr<SimulatedLine> m_training;
    bool m_gaveWay = false; // the training line, to that of a project
    std::unique_ptr<LineSession> m_session;
    Opening m_opening;
    QTimer m_openingTurns;
    const SerialPortLink *m_port = nullptr; // of the session; null: it is at none
    LineSettings m_openedWith;              // the port
    std::optional<KeptAdapter> m_wanted;    // when a port was to be opened last
    SerialPortLink::PortList m_ports = serialPorts;
};

} // namespace codewheel
