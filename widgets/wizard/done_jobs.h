// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/event.h"

namespace codewheel {

// A handshake that takes several jobs, one after the other, told as one: the jobs that are done, and the one
// on its way seen behind them.
class DoneJobs
{
public:
    // steps: all so far, of the jobs before as well.
    void add(std::vector<Step> steps, const Outcome &outcome);

    Progress followedBy(Progress progress) const;
    Outcome followedBy(Outcome outcome) const;

private:
    std::vector<Step> m_steps;
    std::vector<Outcome> m_outcomes;
};

} // namespace codewheel
