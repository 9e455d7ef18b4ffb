// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line/line_session.h"
#include "line/line_wish.h"
#include "links/serial_port_link.h"
#include "project/line_plan.h"
#include "simulator/simulated_line.h"

#include <QObject>

#include <functional>
#include <memory>

namespace codewheel {

class LedgerKeeper;
class ProjectDocument;

// The serial line of the program: the simulated one of the training bus at first, later perhaps one at a
// port. Keeps the account of the EEPROM writes of its encoders. Outlives the window, which is made anew in
// another language.
class SerialLine : public QObject
{
    Q_OBJECT

public:
    using Clock = std::function<QDateTime()>; // what Instant 0 of a line that is opened now stands for

    // Catalog and project outlive it. By hand: the simulated line keeps virtual time. `dataFolder`: of the
    // ledger.
    SerialLine(const Catalog &catalog, ProjectDocument &project, const QString &dataFolder,
               LineSession::Drive drive, Clock clock, QObject *parent = nullptr);
    ~SerialLine() override;

    LineSession *session() const { return m_session.get(); }     // null: none is open
    SimulatedLine *training() const { return m_training.get(); } // null: it is no training line
    const Catalog &catalog() const { return m_catalog; }

    // Each ends the line there was. The training line begins in Operate.
    void openTraining();
    // Begins in Watch, with the encoders of the project and no others, at its adapter wherever that is
    // plugged in. Refused as ByteLink::open(): then the line there was goes on, unless it was at the same
    // port.
    Result<void> openPort(const LinePlan &line);
    // The same once more, with the adapter that it refused (portOfOther) in place of that of the line.
    Result<void> openOtherAdapter(const LinePlan &line);
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
    void aboutToChange(); // session and encoders of before are gone after this
    void changed();       // session() is another one, or none
    void messaged(const codewheel::Message &message, const QDateTime &at);

private:
    void tellByteOrder();
    std::unique_ptr<LineSession> makeSession(std::unique_ptr<ByteLink> link, const LineWish &wish);
    Result<void> open(const LinePlan &line); // at m_wanted
    bool holds(const QString &path) const;
    void replace(std::unique_ptr<LineSession> session, std::shared_ptr<SimulatedLine> training,
                 const SerialPortLink *port);
    void keepAccount();

    const Catalog &m_catalog;
    ProjectDocument &m_project;
    const QString m_dataFolder;
    LineSession::Drive m_drive;
    Clock m_clock;
    std::shared_ptr<SimulatedLine> m_training;
    std::unique_ptr<LineSession> m_session;
    const SerialPortLink *m_port = nullptr; // of the session; null: it is at none
    LineWish m_openedWith;                  // the port
    std::optional<KeptAdapter> m_wanted;    // when a port was to be opened last
    SerialPortLink::PortList m_ports = serialPorts;
    std::unique_ptr<LedgerKeeper> m_ledger; // of the session
};

} // namespace codewheel
