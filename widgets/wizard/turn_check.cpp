// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/turn_check.h"

#include "vocabulary/circle.h"

namespace codewheel {

void TurnCheck::begin(std::int64_t totalRange)
{
    *this = {};
    m_total = totalRange;
}

void TurnCheck::take(std::int64_t position)
{
    const std::int64_t move = shorterWay(m_last.value_or(position), position, m_total);
    m_last = position;
    m_moved += move;
    m_ups += move > 0;
    m_downs += move < 0;
}

TurnCheck::Verdict TurnCheck::verdict() const
{
    if (m_ups == m_downs)
        return m_ups == 0 ? Verdict::doesNotMove : Verdict::goesBothWays;
    return m_ups > m_downs ? Verdict::countsUp : Verdict::countsDown;
}

} // namespace codewheel
