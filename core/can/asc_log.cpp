// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/asc_log.h"

#include "can/can_log_date.h"
#include "can/can_log_words.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr std::string_view baseWord = "base ";
constexpr std::string_view dateWord = "date ";
constexpr std::string_view blockWords = "begin triggerblock";
// What says nothing of the frames.
constexpr std::array<std::string_view, 8> otherHeaders{
    "//",
    ";",
    "internal events logged",
    "no internal events logged",
    "end triggerblock",
    "previous log file",
    "timestamps ",
    "start of measurement",
};

bool isAscHeader(std::string_view text)
{
    const auto begins = [text](std::string_view word) { return beginsWith(text, word); };
    return begins(baseWord) || begins(dateWord) || begins(blockWords) ||
           std::ranges::any_of(otherHeaders, begins);
}

bool hasPoint(std::string_view word)
{
    return word.find('.') != std::string_view::npos;
}

// "185", "18FF1234x"
std::optional<CanFrame> ascFrameWithId(std::string_view word, int base)
{
    const bool isExtended = word.ends_with('x') || word.ends_with('X');
    const auto id = numberIn(word.substr(0, word.size() - (isExtended ? 1 : 0)), base);
    if (!id || *id > (isExtended ? largestExtendedId : largestStandardId))
        return std::nullopt;
    return CanFrame{.id = *id, .isExtended = isExtended};
}

std::optional<CanLogFault> takeAscData(CanFrame &frame, CanLogWords words, int base)
{
    constexpr std::uint32_t largestOctet = 0xFF;
    const auto length = lengthCode(words.next());
    if (!length)
        return CanLogFault::wrongLength;
    for (; frame.length < *length; ++frame.length) {
        if (words.isAtEnd())
            return CanLogFault::wrongLength;
        const auto octet = numberIn(words.next(), base);
        if (!octet || *octet > largestOctet)
            return CanLogFault::badData;
        frame.bytes[frame.length] = static_cast<std::uint8_t>(*octet);
    }
    return numberIn(words.next(), base) ? std::optional(CanLogFault::wrongLength) : std::nullopt;
}

// A length need not be there: "r", "r 8", "r Length = 0".
CanLogLine ascRemote(CanFrame frame, std::string_view length)
{
    frame.isRemote = true;
    frame.length = lengthCode(length).value_or(0);
    const bool isTooLong = length.size() > 1 && numberIn(length, 16);
    return isTooLong ? CanLogLine::faulty(CanLogFault::wrongLength) : CanLogLine{.frame = frame};
}

// As asc2log of can-utils calls a channel, which count from 1 on.
std::string ascInterface(std::string_view channel)
{
    const auto number = numberIn(channel, 10);
    return number.value_or(0) > 0 ? "can" + std::to_string(*number - 1) : "canX";
}

} // namespace

bool AscLog::isItsLine(std::string_view text)
{
    const std::string_view first = CanLogWords(text).next();
    return (hasPoint(first) && secondsIn(first)) || isAscHeader(text);
}

CanLogLine AscLog::line(std::string_view text)
{
    if (beginsWith(text, baseWord))
        return takesBase(text.substr(baseWord.size()));
    if (isAscHeader(text))
        return takesHeader(text);
    CanLogLine line = timed(text);
    m_hasBegun = m_hasBegun || line.frame;
    if (!line.frame && !line.fault && !m_hasBegun)
        return CanLogLine::faulty(CanLogFault::notOfALog);
    return line;
}

CanLogLine AscLog::takesHeader(std::string_view text)
{
    m_hasBegun = m_hasBegun || !beginsWith(text, "//");
    if (beginsWith(text, dateWord))
        return takesDate(text.substr(dateWord.size()));
    const bool isBlock = beginsWith(text, blockWords);
    return isBlock && !m_header.date ? takesDate(text.substr(blockWords.size())) : CanLogLine();
}

CanLogLine AscLog::takesDate(std::string_view text)
{
    m_header.date = ascDate(text);
    const bool isNew = !m_header.date && !m_hasBlamedDate && !CanLogWords(text).isAtEnd();
    m_hasBlamedDate = m_hasBlamedDate || isNew;
    return isNew ? CanLogLine::faulty(CanLogFault::badDate) : CanLogLine();
}

// "hex  timestamps absolute". BUSMASTER leaves out the rest, and the end of the line with it.
CanLogLine AscLog::takesBase(std::string_view text)
{
    m_hasBegun = true;
    CanLogWords words(text);
    m_header.base = beginsWith(words.next(), "dec") ? 10 : 16;
    const std::string_view rest = words.rest();
    if (!beginsWith(words.next(), "timestamps")) {
        m_header.times = AscHeader::Times::ofDay;
        return rest.empty() || isAscHeader(rest) ? CanLogLine() : timed(rest);
    }
    m_header.times =
        beginsWith(words.next(), "relative") ? AscHeader::Times::fromLineBefore : AscHeader::Times::fromDate;
    return {};
}

CanLogLine AscLog::timed(std::string_view text) const
{
    CanLogWords words(text);
    const std::string_view time = words.next();
    const auto at = hasPoint(time) ? secondsIn(time) : std::nullopt;
    if (!at)
        return CanLogLine::faulty(CanLogFault::notOfALog);
    const std::string_view channel = words.next();
    const std::string_view what = words.next();
    CanLogLine line;
    if (channel == "CANFD")
        line = CanLogLine::faulty(CanLogFault::canFd);
    else if (channel == "CANXL")
        line = CanLogLine::faulty(CanLogFault::canXl);
    else if (numberIn(channel, 10))
        line = frame(what, words.rest());
    if (line.frame)
        line.frame->interface = ascInterface(channel);
    line.stamp = {CanLogStamp::Kind::asc, *at};
    return line;
}

// Behind time and channel. What is neither an error frame nor has a direction is an event.
CanLogLine AscLog::frame(std::string_view id, std::string_view behind) const
{
    if (beginsWith(id, "ErrorFrame"))
        return {.frame = CanFrame{.isError = true}};
    CanLogWords words(behind);
    const std::string_view direction = words.next();
    auto read = ascFrameWithId(id, m_header.base);
    if (read && direction.empty())
        return CanLogLine::faulty(CanLogFault::wrongLength);
    if (direction == "TxRq") // only asks for a frame to be sent
        return {};
    const bool isDirection = direction == "Rx" || direction == "Tx";
    const std::string_view type = words.next();
    const bool isRemote = type == "r" || type == "R";
    const bool isData = type == "d" || type == "D";
    if (!isDirection)
        return read && (isRemote || isData) ? CanLogLine::faulty(CanLogFault::badDirection) : CanLogLine();
    if (!read)
        return CanLogLine::faulty(CanLogFault::badIdentifier);
    if (isRemote)
        return ascRemote(*read, words.next());
    if (!isData)
        return CanLogLine::faulty(CanLogFault::badData);
    const auto fault = takeAscData(*read, words, m_header.base);
    return fault ? CanLogLine::faulty(*fault) : CanLogLine{.frame = read};
}

} // namespace codewheel
