// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_at_work.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/line/esc_line_settings.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "links/serial_port_link.h"

#include <memory>

namespace codewheel {

// A serial line of the program: the simulated one of the training bus, or one at a port.
class EscLineAtWork final : public AskedBusAtWork
{
    Q_OBJECT

public:
    EscLineAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);

    QString kind() const override;
    EscLineSession *session() const { return static_cast<EscLineSession *>(present()); } // null: none is open
    SimulatedEscLine *training() const { return m_training.get(); } // null: it is no training line

    void openTraining() override { connectTraining(); }
    // To a line as planned, for testing it.
    std::unique_ptr<ByteLink> makeLink(const EscLinePlan &line) const;
    KindData asOpened(const KindData &plan) const override;
    // Instead of this computer's ports.
    void setPortList(SerialPortLink::PortList ports) { m_ports = std::move(ports); }
    std::vector<PortInfo> ports() const override { return m_ports(); }

private:
    void beginTraining(EncoderBus::Start start) override;
    // At its adapter wherever that is plugged in; agreed: at the one that was refused (portOfOther) instead.
    void beginOpening(const KindData &plan, bool isAgreed) override;
    void detach() override;
    void tellByteOrder();
    std::unique_ptr<EscLineSession> makeSession(std::unique_ptr<ByteLink> link, const EscLineSettings &wish);
    bool holds(const QString &path) const;

    std::shared_ptr<SimulatedEscLine> m_training;
    const SerialPortLink *m_port = nullptr; // of the session; null: not at a port
    std::optional<KeptAdapter> m_wanted;    // when a port was last to be opened
    SerialPortLink::PortList m_ports = serialPorts;
};

} // namespace codewheel
