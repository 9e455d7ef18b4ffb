// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/links/modbus_message.h"

namespace codewheel {

// How a request gets to a unit and its answer back: over TCP or a serial line. ModbusPort has one.
class ModbusWire
{
public:
    virtual ~ModbusWire() = default;

    virtual Result<void> open() = 0;
    virtual void close() = 0;
    // Sends the request once. The answer is that of the unit, undamaged, and of this request as far as the
    // way can tell; nobody has looked at what it says.
    virtual tl::expected<modbus_message::Pdu, RegisterError> exchange(const modbus_message::Pdu &request) = 0;
    // The last answer was not one to its request after all: what comes before the next request is dropped.
    virtual void distrust() = 0;

    // See RegisterPort.
    virtual RegisterPort::Noticed noticed() const = 0;
    virtual Instant now() const = 0;
    virtual void wait(Instant until) = 0;
    virtual void interrupt() = 0;
};

} // namespace codewheel
