// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_status.h"

#include "app/window/look/status_line.h"
#include "bus/bus_outline.h"
#include "kinds/interbus/ring/ring_session.h"

#include <QLabel>
#include <QLocale>

namespace codewheel {
namespace {

QString called(const QString &bus, const QString &state)
{
    return bus.isEmpty() ? state : QStringLiteral("%1: %2").arg(bus, state);
}

int crcErrorsOf(const MasterStatus &master)
{
    int errors = 0;
    for (const MasterStatus::Segment &segment : master.segments)
        errors += static_cast<int>(segment.crcErrors);
    return errors;
}

} // namespace

RingStatus::RingStatus(StatusLine &line)
    : m_line(line)
    , m_cycle(line.addFigure(2, tr("Cycle time"), tr("The time from one exchange of all words to the next")))
    , m_late(line.addFigure(0, tr("Late cycles"),
                            tr("Cycles that began too late; they are counted, not caught up")))
    , m_crc(line.addFigure(1, tr("CRC errors"), tr("Faulty data cycles since the ring was started")))
    , m_link(line.addFigure(3, tr("Link"), tr("How the program is connected to the ring")))
{}

RingStatus::~RingStatus()
{
    for (QLabel *label : {m_cycle, m_late, m_crc, m_link})
        delete label;
}

void RingStatus::show(const RingSession &bus, const QString &gateway)
{
    const Snapshot &snapshot = bus.latest();
    const double period = std::chrono::duration<double, std::milli>(snapshot.period).count();
    const StateWord state = bus.outline().state();
    m_line.setState(state.role, called(nameAmongOthers(bus.id()), state.word));
    m_line.show(
        m_cycle,
        snapshot.figures
            ? tr("%1 exchanges/s").arg(QLocale().toString(snapshot.figures->exchangesPerSecond, 'f', 1))
        : period > 0 ? tr("cycle %1 ms").arg(QLocale().toString(period, 'f', 1))
                     : tr("virtual time"));
    m_line.show(m_late, snapshot.figures
                            ? QString()
                            : tr("%n late cycles", nullptr, static_cast<int>(snapshot.lateCycles)));
    m_line.show(m_crc,
                snapshot.master ? tr("%n CRC errors", nullptr, crcErrorsOf(*snapshot.master)) : QString());
    m_line.show(m_link, tr("link: %1").arg(gateway.isEmpty() ? tr("training bus") : gateway));
    m_line.fit();
}

void RingStatus::clear()
{
    m_line.setState(Role::inactive, tr("not connected"));
    for (QLabel *label : {m_cycle, m_late, m_crc, m_link})
        m_line.show(label, {});
    m_line.fit();
}

} // namespace codewheel
