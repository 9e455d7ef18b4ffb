// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/modbus_library.h"

#include "modbus/gateway_texts.h"

#include <cerrno>

namespace codewheel {

void setAnswerTime(modbus_t *modbus, Instant time)
{
    using namespace std::chrono;
    const Instant left = std::max(time, Instant(1)); // the library does not accept 0
    modbus_set_response_timeout(modbus, static_cast<std::uint32_t>(duration_cast<seconds>(left).count()),
                                static_cast<std::uint32_t>((left % 1s).count()));
    modbus_set_byte_timeout(modbus, 0, 0); // between two bytes: no other limit
    modbus_set_error_recovery(modbus, MODBUS_ERROR_RECOVERY_NONE);
}

RegisterError registerError(RegisterError::Kind kind)
{
    return {kind, 0, {}};
}

RegisterError closedError(int errorNumber)
{
    return {RegisterError::Kind::closed, 0, QString::fromLocal8Bit(modbus_strerror(errorNumber))};
}

RegisterError answerError(int errorNumber)
{
    if (errorNumber == ETIMEDOUT)
        return {RegisterError::Kind::wrongAnswer, 0, GatewayTexts::tr("it is incomplete")};
    if (errorNumber > MODBUS_ENOBASE)
        return {RegisterError::Kind::wrongAnswer, 0, QString::fromLocal8Bit(modbus_strerror(errorNumber))};
    return closedError(errorNumber);
}

} // namespace codewheel
