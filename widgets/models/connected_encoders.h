// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"

#include <QObject>
#include <QPointer>

#include <vector>

namespace codewheel {

class BusSession;
class EncoderSession;
class LineSession;

// The encoders that can be talked to now, whatever bus they are on: those of the ring, and those of the
// serial line. For views that take any encoder and need no word of it.
class ConnectedEncoders : public QObject
{
    Q_OBJECT

public:
    // Both sessions are there longer than what is asked of them here; the line may be replaced.
    explicit ConnectedEncoders(BusSession &bus, QObject *parent = nullptr);

    void setLine(codewheel::LineSession *line); // null: none
    BusSession &bus() const { return m_bus; }
    LineSession *line() const; // null: none

    std::vector<DeviceNumber> numbers() const;          // those of the ring first
    EncoderSession *encoder(DeviceNumber number) const; // null: none, or a device without a driver
    bool isConnected(DeviceNumber number) const;        // also a device that is no encoder

Q_SIGNALS:
    void changed(); // there may be others, or another state of a bus

private:
    BusSession &m_bus;
    QPointer<LineSession> m_line;
};

} // namespace codewheel
