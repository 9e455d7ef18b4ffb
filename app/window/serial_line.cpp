// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/serial_line.h"

#include "drivers/make_driver.h"
#include "simulator/simulated_line_link.h"

#include <chrono>

namespace codewheel {
namespace {

const QString trainingDevice = QStringLiteral("kuebler-esc-rs485");

Instant steadyTime()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

} // namespace

SerialLine::SerialLine(const Catalog &catalog, LineSession::Drive drive, Clock clock, QObject *parent)
    : QObject(parent)
    , m_catalog(catalog)
    , m_drive(drive)
    , m_clock(std::move(clock))
{}

SerialLine::~SerialLine() = default;

void SerialLine::replace(std::unique_ptr<LineSession> session, std::shared_ptr<SimulatedLine> training)
{
    Q_EMIT aboutToChange();
    if (m_session)
        m_session->close();
    m_session = std::move(session);
    m_training = std::move(training);
    Q_EMIT changed();
}

void SerialLine::openTraining()
{
    auto line = std::make_shared<SimulatedLine>();
    const bool isVirtual = m_drive == LineSession::Drive::byHand;
    auto link = std::make_unique<SimulatedLineLink>(line, isVirtual ? SimulatedLineLink::Clock()
                                                                    : SimulatedLineLink::Clock(steadyTime));
    auto session = std::make_unique<LineSession>(std::move(link), m_catalog, m_clock(), makeRequestDriver);
    LineSession &opened = *session;
    replace(std::move(session), line);
    // the messages of these belong to the line already
    if (!opened.open({}, {}, LineSession::Start::operating, m_drive)) // a simulated link always opens
        Q_UNREACHABLE();
    for (const LineAddress address : line->addresses())
        (void)opened.add(address, trainingDevice);
}

void SerialLine::close()
{
    if (m_session)
        replace(nullptr, nullptr);
}

} // namespace codewheel
