// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/esc/protocol/esc_exchange.h"
#include "vocabulary/event.h"
#include "vocabulary/message.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

// How one kind of device on a serial line is driven: a state machine from jobs to requests and from answers
// to readings. Does no I/O and asks no clock. The line asks its drivers in turn what they want to ask next,
// and has one request under way at a time. Line thread only.
class RequestDriver
{
public:
    virtual ~RequestDriver() = default;

    virtual const Reading &reading() const = 0;
    virtual bool busy() const = 0; // with a job

    // What is known of the encoder from elsewhere.
    virtual void setKnown(const std::vector<Known> &known) = 0;

    // Accepts the job or says why not.
    virtual Result<void> begin(JobId id, const Job &job, Pace pace, Instant now) = 0;
    virtual void proceed() = 0; // Pace::byHand: send the next request of the job
    virtual void cancel(OnCancel how, Instant now) = 0;
    // The job ends where it is. An answer still awaited goes to answered() all the same, or to observe() if
    // the line is gone.
    virtual void stop(const Refusal &why, Instant now) = 0;

    // How often it wants the position at most.
    virtual Instant positionInterval() const { return {}; }
    // When next() will want something; empty while it waits for the user.
    virtual std::optional<Instant> wakesAt() const = 0;
    // The request wanted at `now`, given once; empty: none. answered() follows before next() is called again.
    virtual std::optional<esc::Request> next(Instant now) = 0;
    virtual void answered(const esc::Request &request, const esc::ExchangeResult &result, Instant now) = 0;

    // What else the line knows: the rate it uses, in Bd, the devices at its other addresses with a name for
    // the user, and what somebody else asked this device, e.g. at the terminal.
    virtual void setLineBaudRate(int /*baudRate*/) {}
    virtual void setTaken(const std::map<EscLineAddress, QString> & /*others*/) {}
    virtual void observe(const esc::Request & /*request*/, const esc::ExchangeResult & /*result*/,
                         Instant /*now*/)
    {}

    // The line is gone, and what answers when it is back may be another device. Its job has already been
    // stopped.
    virtual void lost(Instant /*now*/) {}
    // For the scaling factor, from now on.
    virtual void setFractionBits(int /*bits*/) {}
    // Whether its warnings come with their two bytes in the other order, from now on.
    virtual void setSwapsWarningBytes(bool /*on*/) {}

    // The address at which the device is asked now; a different one after the job that changed it.
    virtual EscLineAddress address() const = 0;
    // The baud rate that the next request to this device needs, while it is being searched for or was given
    // another one.
    virtual std::optional<int> wantedBaudRate() const { return std::nullopt; }

    // What happened since the last call, oldest first.
    virtual std::vector<Event> takeEvents() = 0;
    virtual std::vector<Message> takeMessages() = 0;
};

// The driver for a device of this description; null if it is not for a serial line. The description must
// outlive the driver.
std::unique_ptr<RequestDriver> makeRequestDriver(const DeviceDescription &device, EscLineAddress address);

} // namespace codewheel
