// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "encoder/message.h"

#include <vector>

namespace codewheel {

// What a ring and a serial line have in common for whoever deals with their encoders alone: the ledger of
// EEPROM writes, jobs for several encoders one after the other, the message log. Implemented by BusSession
// and LineSession.
class EncoderBus : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    virtual std::vector<DeviceNumber> numbers() const = 0; // of all devices, encoders or not
    virtual EncoderSession *
    encoder(DeviceNumber number) const = 0; // null: no driver for it, or no such device

    virtual bool isOpen() const = 0;      // connected
    virtual bool isSimulated() const = 0; // the encoders are
    virtual bool isRunning() const = 0; // RUN; of a serial line: the port is there, and positions are polled
    virtual bool isOperating() const = 0; // writing is allowed

    virtual Instant now() const = 0; // of the newest snapshot
    virtual QDateTime dateTime(Instant at) const = 0;

    virtual void setOperate(bool on) = 0;
    // Jobs end as stopped, and nothing is sent on its own any more; of a ring, all OUT words become 0. From
    // every state, at once.
    virtual void alarmStop() = 0;

Q_SIGNALS:
    void updated();      // a new snapshot; at most once per pump
    void stateChanged(); // connected or not, running or stopped, Watch or Operate
    void messaged(const codewheel::Message &message);
};

} // namespace codewheel
