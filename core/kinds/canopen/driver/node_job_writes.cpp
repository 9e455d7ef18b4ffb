// SPDX-License-Identifier: GPL-3.0-or-later
// What became of the writes of a job.
#include "kinds/canopen/driver/node_job.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "kinds/canopen/protocol/sdo_abort.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace codewheel::canopen {
namespace {

// Of a shaft at rest.
bool isNear(std::int64_t position, std::int64_t other)
{
    constexpr int turned = 2; // steps
    return std::abs(std::int64_t{static_cast<std::int32_t>(position - other)}) <= turned;
}

} // namespace

void NodeJob::writeAnswered(const SdoOutcome &outcome, Instant now)
{
    switch (outcome.kind) {
    case Answer::written:
        accepted(now);
        break;
    case Answer::aborted:
        if (!outcome.isOwnAbort) {
            aborted(outcome);
            break;
        }
        [[fallthrough]]; // what came does not tell what became of it
    default:
        notAnswered();
        break;
    }
}

void NodeJob::accepted(Instant now)
{
    const NodeStep step = m_steps.current();
    m_steps.goOn();
    switch (step.task) {
    case Task::write:
        m_encoder.mayHaveChanged(step);
        for (const ParameterValue &value : step.values) {
            m_account.written(value);
            m_encoder.values.learn(
                {value.parameter, value.value, Evidence::echoed, now, Kept::untilPowerOff});
        }
        break;
    case Task::preset:
        presetAccepted();
        break;
    case Task::writeCam:
        camAccepted(now);
        break;
    case Task::store:
        stored();
        break;
    case Task::restore: // what it has is known again when it is read
        m_encoder.values.countEepromWrite();
        m_encoder.forgetWhatCanBeWritten();
        break;
    case Task::nmt:
        m_encoder.wasCommanded(step.command, now);
        break;
    default:
        break;
    }
}

void NodeJob::stored()
{
    m_encoder.values.countEepromWrite();
    Outcome &outcome = m_account.outcome;
    if (job<StoreParameters>() != nullptr)
        for (const ParameterValue &value : m_encoder.values.values())
            if (mayBeLost(value))
                outcome.stored.push_back(value);
    std::ranges::copy(std::exchange(m_toStore, {}), std::back_inserter(outcome.stored));
    m_encoder.values.haveBeenStored();
}

void NodeJob::presetAccepted()
{
    if (m_encoder.device.capabilities.presetIsStored)
        m_encoder.values.countEepromWrite();
    m_encoder.values.forget(Parameter::offset);
    m_encoder.forgetPosition();
}

void NodeJob::camAccepted(Instant now)
{
    const NodeStep &step = m_steps.done().back();
    if (!m_camsGiven)
        m_camsGiven.emplace();
    codewheel::setValue(*m_camsGiven, step.cam, std::int64_t{static_cast<std::int32_t>(step.number)});
    const bool isLast = m_steps.atEnd() || m_steps.current().task != Task::writeCam;
    m_encoder.takeCams({}); // as long as only a part of it is there
    if (!isLast)
        return;
    m_account.outcome.camsWritten = {*m_camsGiven};
    m_encoder.takeCams(KnownCams{*m_camsGiven, Evidence::echoed, now});
}

// A device that has no command to store keeps what it keeps; whoever wanted nothing else has to know.
void NodeJob::aborted(const SdoOutcome &outcome)
{
    const bool hasNoStore = m_steps.current().task == Task::store && isMissing(outcome);
    if (hasNoStore)
        m_encoder.values.mayHaveBeenStored();
    if (hasNoStore && job<StoreParameters>() == nullptr)
        m_steps.goOn();
    else if (!stopsForIt(outcome))
        failUnsent(refusalOf(outcome));
}

// It was refused because of the state of the node, so it was not carried out, and may be sent again.
bool NodeJob::stopsForIt(const SdoOutcome &outcome)
{
    constexpr std::uint32_t wrongStateCode = 0x0800'0022;
    if (outcome.abortCode != wrongStateCode || !m_encoder.mayRun() ||
        m_hasStopped) // once: somebody else has started it
        return false;
    if (!m_mayStop) {
        fail(m_encoder.wouldStop());
        return true;
    }
    m_startsAgain = m_hasStopped = true;
    m_steps.begun = false;
    m_steps.all.insert(m_steps.rest(), NodePlan::nmt(NmtCommand::preOperational));
    return true;
}

// It is never sent again: the encoder is read instead, and at once.
void NodeJob::notAnswered()
{
    const NodeStep step = m_steps.current();
    m_encoder.mayHaveChanged(step);
    m_unanswered = step;
    switch (step.task) {
    case Task::write:
    case Task::writeCam:
        m_steps.goOn();
        if (m_steps.atEnd() || m_steps.current().task != Task::readBack)
            m_steps.all.insert(m_steps.rest(), m_encoder.plan().readBack(step));
        break;
    case Task::preset:
        m_account.outcome.inDoubt.position = true;
        m_steps.goOn();
        break;
    default: // nothing tells whether that was done
        failAsUnknown();
        break;
    }
}

void NodeJob::readBack(const SdoOutcome &outcome, Instant now)
{
    const NodeStep step = m_steps.current();
    if (outcome.kind != Answer::read) {
        if (m_unanswered)
            failAsUnknown();
        else if (outcome.kind == Answer::noAnswer)
            fail(refusalOf(outcome));
        else
            m_steps.goOn(); // it can only be written
        return;
    }
    const Value whole = m_encoder.valueOf(step.object, outcome.value, outcome.isSizeTold);
    m_encoder.take(step.object, outcome, now);
    if (step.values.empty()) { // of cams
        if (static_cast<std::uint32_t>(whole.number()) != step.number) {
            fail({RefusalKind::device, CanopenRefusalId::sdoWriteNotDone, {step.object.text()}});
            return;
        }
        m_steps.goOn();
        m_unanswered.reset();
        camAccepted(now);
        return;
    }
    for (const ParameterValue &wanted : step.values) {
        const auto has = m_encoder.values.known(wanted.parameter);
        if (has && has->value == wanted.value) {
            m_account.written(wanted);
            m_encoder.values.learn(
                {wanted.parameter, wanted.value, Evidence::read, now, Kept::untilPowerOff});
            continue;
        }
        m_account.notWritten(wanted.parameter);
        fail(m_unanswered
                 ? Refusal{RefusalKind::device, CanopenRefusalId::sdoWriteNotDone, {step.object.text()}}
                 : Refusal{
                       RefusalKind::device,
                       RefusalId::verificationFailed,
                       {wanted.parameter, argumentOf(wanted.value), argumentOf(has ? has->value : whole)}});
        return;
    }
    m_unanswered.reset();
    m_steps.goOn();
}

// It was accepted; a position that stays where it was says otherwise.
void NodeJob::checkPreset()
{
    const Outcome &outcome = m_account.outcome;
    const auto done = m_steps.done();
    const auto preset = std::ranges::find(done, Task::preset, &NodeStep::task);
    if (preset == done.end() || !outcome.positionBefore || !outcome.positionAfter)
        return;
    const std::int64_t wanted{static_cast<std::int32_t>(preset->number)};
    if (isNear(*outcome.positionAfter, *outcome.positionBefore) && !isNear(*outcome.positionAfter, wanted))
        fail({RefusalKind::device, CanopenRefusalId::presetNotInForce, {wanted, *outcome.positionAfter}});
}

// Where the value was another before, it tells; otherwise the position of a shaft at rest does, unless it
// fits both.
void NodeJob::judgePreset()
{
    const std::int64_t wanted = std::int64_t{static_cast<std::int32_t>(m_unanswered->number)};
    const auto has = m_encoder.values.value(Parameter::preset);
    const Outcome &outcome = m_account.outcome;
    std::optional<bool> isDone;
    const auto isWanted = [&](std::int64_t value) {
        return static_cast<std::uint32_t>(value) == static_cast<std::uint32_t>(wanted);
    };
    if (has && m_presetBefore && !isWanted(*m_presetBefore)) {
        if (isWanted(*has))
            isDone = true;
        else if (*has == *m_presetBefore)
            isDone = false;
    } else if (outcome.positionBefore && outcome.positionAfter) {
        const bool isNearWanted = isNear(*outcome.positionAfter, wanted);
        const bool isNearBefore = isNear(*outcome.positionAfter, *outcome.positionBefore);
        if (isNearWanted != isNearBefore)
            isDone = isNearWanted;
    }
    if (!isDone) {
        failAsUnknown();
        return;
    }
    m_account.outcome.inDoubt.position = false;
    m_unanswered.reset();
    if (*isDone)
        presetAccepted();
    else
        fail({RefusalKind::device, CanopenRefusalId::sdoWriteNotDone, {object::preset.text()}});
}

void NodeJob::failAsUnknown()
{
    const NodeStep step = *std::exchange(m_unanswered, std::nullopt);
    noteDoubt(step, m_account.outcome.inDoubt);
    if (step.task == Task::store || step.task == Task::restore)
        m_encoder.values.mayHaveBeenStored();
    if (step.task == Task::store)
        fail({RefusalKind::device, CanopenRefusalId::storingUnknown, {std::int64_t{m_encoder.node}}});
    else
        fail({RefusalKind::device, CanopenRefusalId::sdoWriteUnknown, {step.object.text()}});
}

} // namespace codewheel::canopen
