// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/connected_encoders.h"

#include "line/line_session.h"
#include "ring/bus_session.h"

#include <algorithm>

namespace codewheel {

ConnectedEncoders::ConnectedEncoders(BusSession &bus, QObject *parent)
    : QObject(parent)
    , m_bus(bus)
{
    connect(&bus, &BusSession::stateChanged, this, &ConnectedEncoders::changed);
    connect(&bus, &BusSession::structureChanged, this, &ConnectedEncoders::changed);
    connect(&bus, &BusSession::named, this, &ConnectedEncoders::changed);
}

void ConnectedEncoders::setLine(LineSession *line)
{
    if (m_line)
        m_line->disconnect(this);
    m_line = line;
    if (line) {
        connect(line, &LineSession::stateChanged, this, &ConnectedEncoders::changed);
        connect(line, &LineSession::devicesChanged, this, &ConnectedEncoders::changed);
    }
    Q_EMIT changed();
}

LineSession *ConnectedEncoders::line() const
{
    return m_line;
}

std::vector<DeviceNumber> ConnectedEncoders::numbers() const
{
    std::vector<DeviceNumber> all = m_bus.isOpen() ? m_bus.numbers() : std::vector<DeviceNumber>();
    if (m_line)
        std::ranges::copy(m_line->numbers(), std::back_inserter(all));
    return all;
}

EncoderSession *ConnectedEncoders::encoder(DeviceNumber number) const
{
    if (number.isOnLine())
        return m_line ? m_line->encoder(number) : nullptr;
    return m_bus.isOpen() ? m_bus.encoder(number) : nullptr;
}

bool ConnectedEncoders::isConnected(DeviceNumber number) const
{
    const std::vector<DeviceNumber> all = numbers();
    return std::ranges::find(all, number) != all.end();
}

} // namespace codewheel
