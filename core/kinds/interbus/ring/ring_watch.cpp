// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_watch.h"

namespace codewheel {

std::optional<Message> FaultWatch::look(std::size_t device, const Reading &reading)
{
    if (reading.state == EncoderState::service || reading.state == EncoderState::readOut)
        return std::nullopt; // says nothing about the fault
    std::optional<unsigned> fault;
    if (reading.state == EncoderState::error)
        fault = reading.errorNumber.value_or(0);
    if (fault == m_faults[device])
        return std::nullopt;

    m_faults[device] = fault;
    Message message;
    if (fault) {
        message.severity = Severity::fault;
        message.id = MessageId::deviceFault;
        message.arguments = {std::int64_t{*fault}, reading.in};
    } else {
        message.id = MessageId::deviceFaultGone;
    }
    return message;
}

} // namespace codewheel
