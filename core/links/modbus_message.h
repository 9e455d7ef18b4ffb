// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modbus/register_port.h"

#include <vector>

// Requests and answers as they are on every way: function code and data, without address and checksum (the
// "PDU" of Modbus Application Protocol V1.1b3, 6).
namespace codewheel::modbus_message {

using Message = std::vector<std::uint8_t>;

Message read(int function, int first, std::size_t count);      // 3, 4
Message write(int first, std::span<const Register> registers); // 16
Message writeAndRead(int writeFirst, std::span<const Register> registers, int readFirst,
                     std::size_t count); // 23

// Of the answer to it that is no exception.
std::size_t answerLength(const Message &request);

// The registers of an answer; none are changed unless it is the right one.
RegisterPort::Done take(const Message &request, std::span<const std::uint8_t> answer,
                        std::span<Register> registers);

// An answer that cannot be used; `text` says why.
tl::unexpected<RegisterError> wrongAnswer(const QString &text);

} // namespace codewheel::modbus_message
