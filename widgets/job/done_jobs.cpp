// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/done_jobs.h"

#include <algorithm>

namespace codewheel {
namespace {

template <typename T>
void prepend(std::vector<T> &to, const std::vector<T> &before)
{
    to.insert(to.begin(), before.begin(), before.end());
}

} // namespace

void DoneJobs::add(const Progress &progress, const Outcome &outcome)
{
    m_steps = progress.steps;
    m_haveSetPosition = m_haveSetPosition || progress.setsPosition;
    m_outcomes.push_back(outcome);
}

// The next job cannot restore what a finished one has written.
Progress DoneJobs::followedBy(Progress progress) const
{
    prepend(progress.steps, m_steps);
    progress.index += static_cast<int>(m_steps.size());
    progress.canRestore = progress.canRestore && m_outcomes.empty();
    progress.hasTaken = progress.hasTaken || std::ranges::any_of(m_outcomes, [](const Outcome &outcome) {
                            return !outcome.written.empty();
                        });
    return progress;
}

Outcome DoneJobs::followedBy(Outcome outcome) const
{
    for (auto before = m_outcomes.rbegin(); before != m_outcomes.rend(); ++before) {
        outcome.eepromWrites += before->eepromWrites;
        prepend(outcome.written, before->written);
        prepend(outcome.alreadyThere, before->alreadyThere);
        prepend(outcome.stored, before->stored);
        prepend(outcome.read, before->read);
        prepend(outcome.setAlong, before->setAlong);
        if (before->positionBefore)
            outcome.positionBefore = before->positionBefore;
        if (!outcome.positionAfter)
            outcome.positionAfter = before->positionAfter;
    }
    outcome.isPositionSet = outcome.isPositionSet || (!outcome.result && m_haveSetPosition);
    return outcome;
}

} // namespace codewheel
