// SPDX-License-Identifier: GPL-3.0-or-later
// How a job ends before its end. What was sent cannot be taken back: its answer is waited for, and what was
// written without an answer is read.
#include "kinds/canopen/driver/node_job.h"
#include "kinds/canopen/protocol/canopen_refusals.h"

#include <algorithm>
#include <iterator>

namespace codewheel::canopen {

bool NodeJob::hasTaken() const
{
    return std::ranges::any_of(m_steps.sent(), changesSomething);
}

// Of cams only those of before are known as a whole.
bool NodeJob::canRestore() const
{
    const bool hasGivenCams =
        std::ranges::any_of(m_steps.sent(), [](const NodeStep &step) { return step.task == Task::writeCam; });
    return !hasGivenCams && JobRun::canRestore();
}

// A node that was reset is waited for: its job has to start it again.
void NodeJob::leaveOffAt(Instant /*now*/)
{
    const auto first = std::find_if(m_steps.rest(), m_steps.all.end(), [this](const NodeStep &step) {
        const bool isUnderWay = &step == &m_steps.all[m_steps.index] && m_isUnderWay;
        const bool finishes = step.task == Task::readBack || step.task == Task::bootUp ||
                              step.task == Task::started ||
                              (step.task == Task::positionAfter && hasSentPosition());
        return !isUnderWay && !(finishes && hasTaken());
    });
    const bool keepsBegun = m_steps.begun && first != m_steps.rest();
    m_steps.all.erase(first, m_steps.all.end());
    m_steps.begun = keepsBegun;
    settle();
}

// What was written is in force; it goes on with that, or with what it had.
void NodeJob::goOnAfterCancel()
{
    if (givesBack()) {
        m_restores = true;
        m_steps.append(m_encoder.plan().writes(m_account.valuesBefore(m_account.outcome.written)));
        return;
    }
    const auto done = m_steps.done();
    const auto last = std::find_if(done.rbegin(), done.rend(), [this](const NodeStep &step) {
        return step.task == Task::write || step.task == Task::store || step.task == Task::writeCam ||
               (step.task == Task::preset && !m_encoder.device.capabilities.presetIsStored);
    });
    const bool isToBeStored = last != done.rend() && last->task != Task::store;
    if (m_cancelled == OnCancel::runWithWhatItHas && isToBeStored && !m_failure)
        m_steps.append({NodePlan::store()});
}

void NodeJob::noteDoubt(const NodeStep &step, InDoubt &doubt) const
{
    switch (step.task) {
    case Task::write:
        std::ranges::copy(step.values, std::back_inserter(doubt.values));
        break;
    case Task::preset:
        doubt.position = true;
        doubt.eepromWrites += m_encoder.device.capabilities.presetIsStored ? 1 : 0;
        break;
    case Task::store:
        ++doubt.eepromWrites;
        break;
    case Task::restore:
        doubt.reset = true;
        ++doubt.eepromWrites;
        break;
    case Task::writeCam:
        doubt.camPrograms = {1};
        break;
    default:
        break;
    }
}

// What they have written was taken, and yet it is not known whether this encoder has it.
void NodeJob::doubtDone(std::span<const NodeStep> steps)
{
    InDoubt &doubt = m_account.outcome.inDoubt;
    for (const NodeStep &step : steps) {
        for (const ParameterValue &value : step.task == Task::write ? step.values : ParameterValues()) {
            m_account.notWritten(value.parameter);
            replaceValue(doubt.values, value);
        }
        doubt.position = doubt.position || step.task == Task::preset;
        doubt.reset = doubt.reset || step.task == Task::restore;
        if (step.task == Task::writeCam)
            doubt.camPrograms = {1};
    }
}

void NodeJob::stop(const Refusal &why)
{
    if (isDone())
        return;
    const bool isSending = m_isUnderWay && changesSomething(m_steps.current());
    std::optional<NodeStep> doubtful = m_unanswered;
    if (isSending)
        doubtful = m_steps.current();
    if (doubtful) {
        noteDoubt(*doubtful, m_account.outcome.inDoubt);
        m_encoder.mayHaveChanged(*doubtful);
        if (doubtful->task == Task::store)
            m_encoder.values.mayHaveBeenStored();
        if (doubtful->task == Task::writeCam)
            m_encoder.takeCams({});
    }
    if (why.id == CanopenRefusalId::nodeDoubled) {
        doubtDone(m_steps.done());
        m_account.outcome.read.clear();
    }
    if (endsOutOfSight(why))
        leaveOutOfSight();
    finish(tl::unexpected(why));
}

} // namespace codewheel::canopen
