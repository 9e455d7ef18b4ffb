// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modbus/register_port.h"

#include <memory>
#include <modbus.h>

namespace codewheel {

struct CloseModbus
{
    void operator()(modbus_t *modbus) const
    {
        modbus_close(modbus);
        modbus_free(modbus);
    }
};
using Modbus = std::unique_ptr<modbus_t, CloseModbus>; // closes its descriptor

// An answer must be complete within this time, and is taken for gone otherwise; the library repeats and
// reconnects nothing by itself.
void setAnswerTime(modbus_t *modbus, Instant time);

RegisterError registerError(RegisterError::Kind kind);

// The connection is gone, by the system's error number.
RegisterError closedError(int errorNumber);

// What a failure of the library while it was reading an answer means, by its error number.
RegisterError answerError(int errorNumber);

} // namespace codewheel
