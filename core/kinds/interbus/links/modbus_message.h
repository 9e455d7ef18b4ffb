// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/modbus_request.h"
#include "kinds/interbus/gateway/register_texts.h"

// Requests and answers as they are on every way: function code and data, without address and checksum (the
// "PDU" of Modbus Application Protocol V1.1b3, 6).
namespace codewheel::modbus_message {

using Pdu = ModbusBytes;

Pdu read(int function, int first, std::size_t count);      // 3, 4
Pdu write(int first, std::span<const Register> registers); // 16
Pdu writeAndRead(int writeFirst, std::span<const Register> registers, int readFirst,
                 std::size_t count); // 23

bool writes(const Pdu &request);
// Of the answer to it that is no exception.
std::size_t answerLength(const Pdu &request);

// Whether it has the form of an answer to this request, or of an exception.
bool mayAnswer(const Pdu &request, const Pdu &answer);

// The registers of an answer; none are changed unless it is the right one.
RegisterPort::Done take(const Pdu &request, std::span<const std::uint8_t> answer,
                        std::span<Register> registers);

// An answer that cannot be used.
tl::unexpected<RegisterError> wrongAnswer(WrongAnswer what, std::initializer_list<int> numbers = {});

} // namespace codewheel::modbus_message
