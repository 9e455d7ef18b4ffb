// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line/line_session.h"
#include "simulator/simulated_line.h"

#include <QObject>

#include <functional>
#include <memory>

namespace codewheel {

// The serial line of the program: the simulated one of the training bus at first, later perhaps one at a
// port. Outlives the window, which is made anew in another language.
class SerialLine : public QObject
{
    Q_OBJECT

public:
    using Clock = std::function<QDateTime()>; // what Instant 0 of a line that is opened now stands for

    // The catalog outlives it. By hand: the simulated line keeps virtual time.
    SerialLine(const Catalog &catalog, LineSession::Drive drive, Clock clock, QObject *parent = nullptr);
    ~SerialLine() override;

    LineSession *session() const { return m_session.get(); }     // null: none is open
    SimulatedLine *training() const { return m_training.get(); } // null: it is no training line
    const Catalog &catalog() const { return m_catalog; }

    // Each ends the line there was. The training line begins in Operate.
    void openTraining();
    void close();

Q_SIGNALS:
    void aboutToChange(); // session and encoders of before are gone after this
    void changed();       // session() is another one, or none

private:
    void replace(std::unique_ptr<LineSession> session, std::shared_ptr<SimulatedLine> training);

    const Catalog &m_catalog;
    LineSession::Drive m_drive;
    Clock m_clock;
    std::shared_ptr<SimulatedLine> m_training;
    std::unique_ptr<LineSession> m_session;
};

} // namespace codewheel
