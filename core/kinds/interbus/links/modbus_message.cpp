// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_message.h"

#include <algorithm>

namespace codewheel::modbus_message {
namespace {

using Done = RegisterPort::Done;

constexpr std::uint8_t writeFunction = 16;
constexpr std::uint8_t writeAndReadFunction = 23;
constexpr std::uint8_t exceptionBit = 0x80;
constexpr std::size_t readCountAt = 3; // in the requests 3, 4 and 23
constexpr std::size_t exceptionLength = 2;
constexpr std::size_t echoLength = 5; // function, first register, count

void append(Pdu &message, std::size_t number)
{
    message.push_back(static_cast<std::uint8_t>(number >> 8 & 0xFF));
    message.push_back(static_cast<std::uint8_t>(number & 0xFF));
}

void appendRegisters(Pdu &message, std::span<const Register> registers)
{
    append(message, registers.size());
    message.push_back(static_cast<std::uint8_t>(2 * registers.size()));
    for (const Register one : registers)
        append(message, one);
}

Done takeException(std::span<const std::uint8_t> answer)
{
    if (answer.size() != exceptionLength)
        return wrongAnswer(WrongAnswer::lengthOfException);
    return tl::unexpected(RegisterError{RegisterError::Kind::exception, answer[1], {}});
}

} // namespace

Pdu read(int function, int first, std::size_t count)
{
    Pdu message{static_cast<std::uint8_t>(function)};
    append(message, static_cast<std::size_t>(first));
    append(message, count);
    return message;
}

Pdu write(int first, std::span<const Register> registers)
{
    Pdu message{writeFunction};
    append(message, static_cast<std::size_t>(first));
    appendRegisters(message, registers);
    return message;
}

Pdu writeAndRead(int writeFirst, std::span<const Register> registers, int readFirst, std::size_t count)
{
    Pdu message{writeAndReadFunction};
    append(message, static_cast<std::size_t>(readFirst));
    append(message, count);
    append(message, static_cast<std::size_t>(writeFirst));
    appendRegisters(message, registers);
    return message;
}

bool writes(const Pdu &request)
{
    return request.front() == writeFunction || request.front() == writeAndReadFunction;
}

std::size_t answerLength(const Pdu &request)
{
    if (request.front() == writeFunction)
        return echoLength;
    return 2 + 2 * std::size_t{registerAt(request, readCountAt)};
}

bool mayAnswer(const Pdu &request, const Pdu &answer)
{
    if (answer.empty() || (answer.front() & ~exceptionBit) != request.front())
        return false;
    return answer.size() == ((answer.front() & exceptionBit) != 0 ? exceptionLength : answerLength(request));
}

Done take(const Pdu &request, std::span<const std::uint8_t> answer, std::span<Register> registers)
{
    const std::uint8_t function = request.front();
    if (!answer.empty() && answer[0] == (function | exceptionBit))
        return takeException(answer);
    if (answer.empty() || answer[0] != function)
        return wrongAnswer(WrongAnswer::function, {answer.empty() ? 0 : answer[0] & ~exceptionBit});
    if (answer.size() != answerLength(request))
        return wrongAnswer(WrongAnswer::length,
                           {static_cast<int>(answer.size()), static_cast<int>(answerLength(request))});
    if (function == writeFunction) {
        if (!std::equal(answer.begin(), answer.end(), request.begin()))
            return wrongAnswer(WrongAnswer::otherRegisters);
        return {};
    }
    if (answer[1] != answer.size() - 2)
        return wrongAnswer(WrongAnswer::count);
    for (std::size_t i = 0; i < registers.size(); ++i)
        registers[i] = registerAt(answer, 2 + 2 * i);
    return {};
}

tl::unexpected<RegisterError> wrongAnswer(WrongAnswer what, std::initializer_list<int> numbers)
{
    return tl::unexpected(RegisterError{RegisterError::Kind::wrongAnswer, 0, wrongAnswerKey(what, numbers)});
}

} // namespace codewheel::modbus_message
