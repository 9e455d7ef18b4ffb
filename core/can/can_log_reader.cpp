// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_reader.h"

#include "can/can_log_words.h"

namespace codewheel {
namespace {

constexpr std::size_t longestLine = 16'384; // one of CAN XL has some 6 000
constexpr std::size_t mostWaiting = 10'000; // lines, until it is decided what their times are
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

std::string_view withoutBlanksAround(std::string_view text)
{
    text = CanLogWords(text).rest();
    return text.substr(0, text.find_last_not_of(" \t\r\v\f") + 1);
}

} // namespace

CanLogReader::CanLogReader(TakeFrame takeFrame, TakeFault takeFault, std::optional<CanLogTimes> meant)
    : m_takeFrame(std::move(takeFrame))
    , m_takeFault(std::move(takeFault))
    , m_clock(meant)
{}

void CanLogReader::read(std::string_view bytes)
{
    for (auto end = bytes.find('\n'); end != std::string_view::npos; end = bytes.find('\n')) {
        gather(bytes.substr(0, end));
        endLine();
        bytes.remove_prefix(end + 1);
    }
    gather(bytes);
}

void CanLogReader::finish()
{
    if (!m_part.empty())
        endLine();
    breakOff();
}

void CanLogReader::breakOff()
{
    m_clock.decide();
    passAll();
}

void CanLogReader::gather(std::string_view part)
{
    m_isTooLong = m_isTooLong || m_part.size() + part.size() > longestLine;
    m_part.append(part.substr(0, longestLine - std::min(m_part.size(), longestLine)));
}

void CanLogReader::endLine()
{
    ++m_line;
    std::string_view text = m_part;
    if (m_line == 1 && text.starts_with(byteOrderMark))
        text.remove_prefix(byteOrderMark.size());
    if (m_isTooLong)
        blame(CanLogFault::tooLong, m_line);
    else
        readLine(text);
    m_isTooLong = false;
    m_part.clear();
}

void CanLogReader::readLine(std::string_view text)
{
    const bool isExplanation = m_mayBeExplained && text.starts_with('\t');
    text = withoutBlanksAround(text);
    if (isExplanation || text.empty())
        return;
    const CanLogLine line = lineOf(text);
    m_mayBeExplained = line.frame && line.frame->isError;
    if (line.fault)
        blame(*line.fault, m_line);
    m_clock.look(line.stamp);
    if (m_clock.isDecided() && m_waiting.empty())
        pass({line.frame, line.stamp, m_line});
    else
        m_waiting.push_back({line.frame, line.stamp, m_line});
    if (m_waiting.size() >= mostWaiting) // few of which have a time
        m_clock.decide();
    if (m_clock.isDecided())
        passAll();
}

CanLogLine CanLogReader::lineOf(std::string_view text)
{
    return AscLog::isItsLine(text) ? m_asc.line(text) : m_candump.line(text);
}

void CanLogReader::blame(CanLogFault fault, std::int64_t line)
{
    m_canFdFrames += fault == CanLogFault::canFd ? 1 : 0;
    m_takeFault(line, fault);
}

void CanLogReader::pass(const Waiting &line)
{
    const CanLogTime time = m_clock.at(line.stamp, m_asc.header(), line.frame.has_value());
    if (!line.frame)
        return;
    if (time.isOfOtherKind)
        blame(CanLogFault::otherTime, line.number);
    CanFrame frame = *line.frame;
    frame.time = time.at;
    ++m_frames;
    m_takeFrame(frame);
}

void CanLogReader::passAll()
{
    for (const Waiting &line : m_waiting)
        pass(line);
    m_waiting.clear();
}

} // namespace codewheel
