// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_figures.h"

#include <algorithm>

namespace codewheel {

void LineCounter::note(const esc::ExchangeResult &result)
{
    m_figures.requests += static_cast<std::uint64_t>(result.sent);
    m_figures.retries += static_cast<std::uint64_t>(std::max(0, result.sent - 1));
    m_figures.timeOuts += static_cast<std::uint64_t>(result.timeOuts);
    m_figures.garbageBytes += static_cast<std::uint64_t>(result.garbageBytes);
    m_figures.lateBytes += static_cast<std::uint64_t>(result.lateBytes);
    if (!result.answer) {
        ++m_figures.unanswered;
        noteMissing(result);
        return;
    }
    m_figures.sinceAnswer = {};
    ++m_figures.answers;
    m_figures.answerTime = m_times.note(result.answerTime);
}

void LineCounter::noteMissing(const esc::ExchangeResult &result)
{
    SinceAnswer &since = m_figures.sinceAnswer;
    since.requests += static_cast<std::uint64_t>(result.sent);
    since.strayBytes += static_cast<std::uint64_t>(result.garbageBytes + result.lateBytes);
    since.isEchoed = result.isEchoed;
}

} // namespace codewheel
