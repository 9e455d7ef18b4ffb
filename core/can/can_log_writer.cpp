// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_writer.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr int idDigits = 3;
constexpr int longIdDigits = 8; // also of a small one, which tells it apart

void appendHex(std::string &text, std::uint32_t number, int digits)
{
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        text += "0123456789ABCDEF"[(number >> shift) & 0xF];
}

void appendTime(std::string &text, Instant time)
{
    constexpr std::size_t secondDigits = 10;
    constexpr std::size_t decimals = 6; // tshark wants them all
    const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
    const std::string whole = std::to_string(seconds.count());
    const std::string fraction = std::to_string((time - seconds).count());
    text += '(';
    text.append(secondDigits - std::min(secondDigits, whole.size()), '0').append(whole) += '.';
    text.append(decimals - fraction.size(), '0').append(fraction) += ") ";
}

} // namespace

std::string canLogLine(const CanFrame &frame)
{
    std::string text;
    appendTime(text, std::max(frame.time.value_or(Instant()), Instant()));
    text.append(frame.interface.empty() ? "can0" : frame.interface) += ' ';
    if (frame.isError)
        appendHex(text, frame.id | errorFrameFlag, longIdDigits);
    else
        appendHex(text, frame.id, frame.isExtended ? longIdDigits : idDigits);
    text += '#';
    if (frame.isRemote)
        text += 'R' + (frame.length == 0 ? std::string() : std::to_string(frame.length));
    // An error frame always has all its bytes.
    for (const std::uint8_t byte : frame.isError ? std::span<const std::uint8_t>(frame.bytes) : frame.data())
        appendHex(text, byte, 2);
    return text += '\n';
}

} // namespace codewheel
