// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/candump_log.h"

#include "can/can_log_words.h"

namespace codewheel {
namespace {

constexpr std::size_t digitsOfStandardId = 3;
constexpr std::size_t digitsOfExtendedId = 8;
constexpr int hexadecimal = 16;
constexpr std::size_t longestInterface = 64; // that of Linux is 15

std::optional<CanFrame> frameWithId(std::string_view digits)
{
    const auto id = numberIn(digits, hexadecimal);
    const bool isExtended = digits.size() == digitsOfExtendedId;
    if (!id || (!isExtended && digits.size() != digitsOfStandardId))
        return std::nullopt;
    const bool isError = isExtended && (*id & errorFrameFlag) != 0;
    const std::uint32_t bits = isError ? *id & ~errorFrameFlag : *id;
    if (bits > (isExtended ? largestExtendedId : largestStandardId))
        return std::nullopt;
    return CanFrame{.id = bits, .isExtended = isExtended && !isError, .isError = isError};
}

// Empty: it is no octet.
std::optional<std::uint8_t> hexOctet(std::string_view digits)
{
    const auto number = digits.size() == 2 ? numberIn(digits, hexadecimal) : std::nullopt;
    return number ? std::optional(static_cast<std::uint8_t>(*number)) : std::nullopt;
}

// "88130000", "88.13.00.00", "1122334455667788_9"
std::optional<CanLogFault> takeData(CanFrame &frame, std::string_view text)
{
    text = text.substr(0, text.find('_'));
    while (!text.empty()) {
        if (text.front() == '.') {
            text.remove_prefix(1);
            continue;
        }
        const auto octet = hexOctet(text.substr(0, 2));
        if (!octet)
            return CanLogFault::badData;
        if (frame.length == CanFrame::mostBytes)
            return CanLogFault::wrongLength;
        frame.bytes[frame.length++] = *octet;
        text.remove_prefix(2);
    }
    return std::nullopt;
}

// "R", "R8", "R8_9"
std::optional<CanLogFault> takeRemote(CanFrame &frame, std::string_view text)
{
    if (frame.isError)
        return CanLogFault::badData;
    text = text.substr(0, text.find('_'));
    const auto length = text.empty() ? std::uint8_t{0} : lengthCode(text);
    if (!length)
        return CanLogFault::wrongLength;
    frame.isRemote = true;
    frame.length = *length;
    return std::nullopt;
}

// "R" and "T" say who sent it.
CanLogLine logFrameWithDirection(std::string_view text, CanLogWords words)
{
    const std::string_view direction = words.next();
    const bool isOne = direction.empty() || direction == "R" || direction == "T";
    return isOne && words.isAtEnd() ? CandumpLog::frame(text) : CanLogLine::faulty(CanLogFault::notOfALog);
}

std::optional<CanLogFault> takeScreenData(CanFrame &frame, std::uint8_t length, CanLogWords words)
{
    for (; frame.length < length; ++frame.length) {
        const std::string_view word = words.next();
        const auto octet = hexOctet(word);
        if (!octet)
            return word.empty() ? CanLogFault::wrongLength : CanLogFault::badData;
        frame.bytes[frame.length] = *octet;
    }
    const std::string_view rest = words.rest(); // the same as ASCII, or what an error frame is called
    if (rest.empty() || rest.front() == '\'' || rest.front() == '"' || rest == "ERRORFRAME")
        return std::nullopt;
    return hexOctet(words.next()) ? CanLogFault::wrongLength : CanLogFault::badData;
}

// "057", then "[8]  C7 35 ..", "[0]  remote request"
CanLogLine screenFrame(std::string_view id, CanLogWords words)
{
    const std::string_view length = words.next();
    if (length.size() < 3 || length.front() != '[' || length.back() != ']')
        return CanLogLine::faulty(CanLogFault::notOfALog);
    const std::string_view digits = length.substr(1, length.size() - 2);
    if (digits.size() == 2 && numberIn(digits, 10)) // candump writes those of CAN FD with two
        return CanLogLine::faulty(CanLogFault::canFd);
    auto frame = frameWithId(id);
    if (!frame)
        return CanLogLine::faulty(CanLogFault::badIdentifier);
    const auto number = digits.size() == 1 ? numberIn(digits, 10) : std::nullopt;
    if (!number || *number > CanFrame::mostBytes)
        return CanLogLine::faulty(CanLogFault::wrongLength);
    const auto bytes = static_cast<std::uint8_t>(*number);
    const auto fault = beginsWith(words.rest(), "remote request") ? takeRemote(*frame, digits)
                                                                  : takeScreenData(*frame, bytes, words);
    return fault ? CanLogLine::faulty(*fault) : CanLogLine{.frame = frame};
}

// Behind the time. On the screen there may be the direction and two flags before the identifier.
CanLogLine timedLine(std::string_view text)
{
    CanLogWords words(text);
    const std::string_view interface = words.next();
    std::string_view word = words.next();
    CanLogLine line;
    if (word.find('#') != std::string_view::npos) {
        line = logFrameWithDirection(word, words);
    } else {
        if (word == "RX" || word == "TX") {
            words.next();
            words.next();
            word = words.next();
        }
        line = screenFrame(word, words);
    }
    if (line.frame)
        line.frame->interface = interface.substr(0, longestInterface);
    return line;
}

} // namespace

CanLogLine CandumpLog::frame(std::string_view text)
{
    const auto hash = text.find('#');
    const std::string_view data = text.substr(hash + 1);
    if (data.starts_with('#'))
        return CanLogLine::faulty(CanLogFault::canFd);
    if (data.find('#') != std::string_view::npos)
        return CanLogLine::faulty(CanLogFault::canXl);
    auto frame = frameWithId(text.substr(0, hash));
    if (!frame)
        return CanLogLine::faulty(CanLogFault::badIdentifier);
    const auto fault = beginsWith(data, "R") ? takeRemote(*frame, data.substr(1)) : takeData(*frame, data);
    return fault ? CanLogLine::faulty(*fault) : CanLogLine{.frame = frame};
}

CanLogLine CandumpLog::line(std::string_view text)
{
    if (!text.starts_with('('))
        return timedLine(text);
    const auto end = text.find(')');
    if (end == std::string_view::npos)
        return CanLogLine::faulty(CanLogFault::badTime);
    const std::string_view time = text.substr(1, end - 1);
    const bool isDate = time.find(' ') != std::string_view::npos && time.front() != ' ';
    const auto at = isDate ? m_dates.at(time) : secondsIn(CanLogWords(time).rest());
    if (!at)
        return CanLogLine::faulty(CanLogFault::badTime);
    CanLogLine line = timedLine(text.substr(end + 1));
    line.stamp = {isDate ? CanLogStamp::Kind::date : CanLogStamp::Kind::candump, *at};
    return line;
}

} // namespace codewheel
