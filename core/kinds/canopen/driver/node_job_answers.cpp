// SPDX-License-Identifier: GPL-3.0-or-later
// What the answers to the steps of a job mean.
#include "kinds/canopen/driver/node_job.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "kinds/canopen/protocol/sdo_abort.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {

void NodeJob::answered(const SdoOutcome &outcome, Instant now)
{
    m_isUnderWay = false;
    if (isDone())
        return;
    const NodeStep &step = m_steps.current();
    if (outcome.kind == Answer::notSent && m_unanswered)
        failAsUnknown(); // it was to be read back
    else if (outcome.kind == Answer::notSent)
        failUnsent({RefusalKind::link,
                    CanopenRefusalId::sdoNotSent,
                    {step.task == Task::nmt ? QStringLiteral("NMT") : step.object.text(),
                     std::int64_t{m_encoder.node}}});
    else if (step.task == Task::readBack)
        readBack(outcome, now);
    else if (changesSomething(step))
        writeAnswered(outcome, now);
    else
        readAnswered(outcome, now);
    settle();
}

void NodeJob::readAnswered(const SdoOutcome &outcome, Instant now)
{
    const NodeStep step = m_steps.current();
    if (outcome.kind != Answer::read) {
        notRead(outcome);
        return;
    }
    m_encoder.take(step.object, outcome, now);
    const Value value = m_encoder.valueOf(step.object, outcome.value, outcome.isSizeTold);
    m_steps.goOn();
    switch (step.task) {
    case Task::read:
        noteRead(step);
        break;
    case Task::bits:
        m_whole = value;
        break;
    case Task::readCam:
        codewheel::setValue(m_camsRead, step.cam, value.number());
        break;
    case Task::vendor:
        checkVendor(outcome);
        break;
    case Task::refresh:
        if (step.object == object::preset && !m_unanswered && !hasTaken())
            m_presetBefore = value.number();
        break;
    default:
        notePosition(step);
        break;
    }
}

void NodeJob::noteRead(const NodeStep &step)
{
    for (const Parameter parameter : step.parameters)
        if (const auto known = m_encoder.values.known(parameter))
            m_account.read({parameter, known->value});
}

void NodeJob::notePosition(const NodeStep &step)
{
    Outcome &outcome = m_account.outcome;
    if (step.task == Task::positionAfter) {
        outcome.positionAfter = m_encoder.reading.position;
        if (m_unanswered)
            judgePreset();
        else
            checkPreset();
    } else if (!outcome.positionBefore) // when restoring, it was read before the first write
        outcome.positionBefore = m_encoder.reading.position;
}

// What the encoder does not have is left out, and the rest is read. A job that goes on to write only wants to
// compare: what cannot be compared is written.
void NodeJob::notRead(const SdoOutcome &outcome)
{
    const Task task = m_steps.current().task;
    const Refusal why = refusalOf(outcome);
    if (outcome.kind == Answer::noAnswer || task == Task::bits || task == Task::readCam ||
        task == Task::vendor) {
        if (m_unanswered)
            failAsUnknown();
        else
            fail(why);
        return;
    }
    if (isMissing(outcome) && !m_missing)
        m_missing = why;
    const bool isForItself = job<ReadParameters>() != nullptr;
    if (task == Task::read && isForItself && !isMissing(outcome) && !m_failure)
        m_failure = why;
    if (task == Task::positionAfter && m_unanswered)
        failAsUnknown();
    else
        m_steps.goOn();
}

void NodeJob::checkVendor(const SdoOutcome &outcome)
{
    const auto wanted = canopenDevice(m_encoder.device).vendor;
    const std::uint32_t has = numberOf(outcome.value);
    if (wanted && *wanted == has)
        return;
    const auto makers = std::ranges::find_if(
        m_steps.all, [](const NodeStep &step) { return step.task == Task::write && isMakers(step.object); });
    const QString object = makers != m_steps.all.end() ? makers->object.text() : QString();
    noteFailure({RefusalKind::badInput,
                 CanopenRefusalId::makeDiffers,
                 {object, Word{wanted.value_or(0)}, Word{has}}});
}

void NodeJob::fail(Refusal why)
{
    m_unanswered.reset();
    noteFailure(std::move(why));
}

// What was reported as begun is not done.
void NodeJob::failUnsent(Refusal why)
{
    fail(std::move(why));
    reportProgress(false);
}

Refusal NodeJob::refusalOf(const SdoOutcome &outcome) const
{
    const QString object = m_steps.current().object.text();
    if (outcome.kind == Answer::aborted && !outcome.isOwnAbort)
        return {RefusalKind::device, CanopenRefusalId::sdoAborted, {object, Word{outcome.abortCode}}};
    return {RefusalKind::device, CanopenRefusalId::sdoNoAnswer, {object, std::int64_t{m_encoder.node}}};
}

} // namespace codewheel::canopen
