// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include "vocabulary/port_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
SimulatedEscLineLink::SimulatedEscLineLink(std::shared_ptr<SimulatedEscLine> line, Clock clock)
    : m_line(std::move(line))
    , m_clock(std::move(clock))
    , m_begin(m_clock ? m_clock() : Instant())
{}

Result<void> SimulatedEscLineLink::open(const SerialSettings &settings)
{
    if (m_line->isUnplugged())
        return refuse(RefusalKind::link, RefusalId::portNotFound, {QString(trainingPort)});
    m_line->begin(settings, now());
    m_open = true;
    return {};
}

Result<void> SimulatedEscLineLink::setBaudRate(int baudRate)
{
    return usable().map([&] { m_line->setBaudRate(baudRate); });
}

QString SimulatedEscLineLink::name() const
{
    return QCoreApplication::translate("SimulatedEscLine", "training line");
}

void SimulatedEscLineLink::wait(Instant until)
{
    if (!m_clock)
        m_now = std::max(m_now, until);
    else
        m_line->waitForWake(until - now());
}

Result<void> SimulatedEscLineLink::write(const QByteArray &bytes)
{
    return usable().map([&] { m_line->send(bytes, now()); });
}

Result<QByteArray> SimulatedEscLineLink::read(Instant until)
{
    if (const auto checked = usable(); !checked)
        return tl::unexpected(checked.error());
    if (m_line->takeWake())
        return QByteArray();
    QByteArray bytes = m_clock ? readReally(until) : readVirtually(until);
    if (const auto checked = usable(); !checked)
        return tl::unexpected(checked.error());
    return bytes;
}

Result<void> SimulatedEscLineLink::usable()
{
    if (!m_open)
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    if (m_line->isUnplugged()) {
        m_open = false;
        return refuse(RefusalKind::link, RefusalId::portLost, {QString(trainingPort)});
    }
    return {};
}

QByteArray SimulatedEscLineLink::readVirtually(Instant until)
{
    const SimulatedEscLine::Arrival arrival = m_line->advance(std::max(until, m_now));
    m_now = arrival.at;
    return arrival.bytes;
}

QByteArray SimulatedEscLineLink::readReally(Instant until)
{
    QByteArray bytes;
    for (bool goOn = true; goOn;) {
        const Instant time = now();
        for (auto more = m_line->advance(time); !more.bytes.isEmpty(); more = m_line->advance(time))
            bytes += more.bytes;
        if (!bytes.isEmpty() || time >= until)
            break;
        goOn = m_line->wait(std::min(until, m_line->runEnd().value_or(until)) - time);
    }
    return bytes;
}

} // namespace codewheel
