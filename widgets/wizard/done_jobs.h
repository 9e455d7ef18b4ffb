// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

namespace codewheel {

// Presents a handshake of several consecutive jobs as one: the finished jobs, followed by the running one.
class DoneJobs
{
public:
    // steps: all so far, including those of previous jobs.
    void add(std::vector<Step> steps, const Outcome &outcome);

    Progress followedBy(Progress progress) const;
    Outcome followedBy(Outcome outcome) const;

private:
    std::vector<Step> m_steps;
    std::vector<Outcome> m_outcomes;
};

} // namespace codewheel
