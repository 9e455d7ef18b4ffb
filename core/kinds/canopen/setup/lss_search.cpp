// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/setup/lss_search.h"

#include <utility>

namespace codewheel::canopen {

std::optional<NodeTask::Request> LssSearch::next(const CanopenSnapshot & /*bus*/)
{
    if (m_isAsked || m_hasLeft)
        return std::nullopt;
    m_isAsked = true;
    m_isLeaving = !isSearching();
    return m_isLeaving ? LssRequest{.kind = LssRequest::Kind::operateAll} : *m_selection.next();
}

void LssSearch::answered(const LssOutcome &outcome)
{
    if (!std::exchange(m_isAsked, false))
        return;
    if (!m_isLeaving) {
        m_selection.take(outcome);
        return;
    }
    m_mayStay = outcome.kind != LssOutcome::Kind::done;
    m_hasLeft = true;
}

} // namespace codewheel::canopen
