// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/rtu_answers.h"

#include "kinds/interbus/gateway/rtu_frame.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

using AnswerBytes = std::span<const std::uint8_t>;

constexpr std::size_t unitLength = 1;
constexpr std::size_t crcLength = 2;
constexpr std::size_t longestFrame = 256;

// The frame of an answer that these bytes begin with; empty: they do not.
AnswerBytes answerFrameAt(AnswerBytes bytes)
{
    const std::size_t length = modbusAnswerLength(bytes.subspan(std::min(unitLength, bytes.size())));
    const std::size_t whole = unitLength + length + crcLength;
    if (length == 0 || bytes.size() < whole || modbusCrc(bytes.first(whole)) != 0)
        return {};
    return bytes.first(whole);
}

bool beginsWith(AnswerBytes bytes, AnswerBytes begin)
{
    return bytes.size() >= begin.size() && std::equal(begin.begin(), begin.end(), bytes.begin());
}

} // namespace

void RtuAnswers::begin(ModbusBytes request)
{
    drop(m_bytes.size(), m_bytes.size());
    m_request = std::move(request);
}

void RtuAnswers::take(std::span<const std::uint8_t> bytes)
{
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
}

void RtuAnswers::drop(std::size_t bytes, std::size_t strays)
{
    m_bytes.erase(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(bytes));
    m_strayBytes += strays;
}

// On a line that has echoed before, what its echo begins with is no answer yet.
bool RtuAnswers::mayBeEcho(AnswerBytes bytes) const
{
    return m_echoes > 0 && !m_request.empty() && beginsWith(m_request, bytes);
}

std::optional<RtuAnswers::Frame> RtuAnswers::next()
{
    for (std::size_t begin = 0; begin < m_bytes.size(); ++begin) {
        const AnswerBytes rest = AnswerBytes(m_bytes).subspan(begin);
        if (!m_request.empty() && beginsWith(rest, m_request)) {
            drop(begin + std::exchange(m_request, {}).size(), begin);
            ++m_echoes;
            return next();
        }
        const AnswerBytes frame = answerFrameAt(rest);
        if (frame.empty() || mayBeEcho(rest))
            continue;
        Frame found{frame.front(), {frame.begin() + unitLength, frame.end() - crcLength}};
        drop(begin + frame.size(), begin);
        return found;
    }
    if (m_bytes.size() > longestFrame) // the first of them begin no frame any more
        drop(m_bytes.size() - longestFrame, m_bytes.size() - longestFrame);
    return std::nullopt;
}

} // namespace codewheel
