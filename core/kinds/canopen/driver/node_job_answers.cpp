// SPDX-License-Identifier: GPL-3.0-or-later
// What the answers to the steps of a job mean.
#include "catalog/kept_values.h"
#include "kinds/canopen/driver/node_job.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "kinds/canopen/protocol/nmt_job.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace codewheel::canopen {
namespace {

namespace abort_code {
constexpr std::uint32_t noObject = 0x0602'0000;
constexpr std::uint32_t noSubindex = 0x0609'0011;
constexpr std::uint32_t wrongState = 0x0800'0022;
} // namespace abort_code

using Answer = SdoOutcome::Kind;

bool isMissing(const SdoOutcome &outcome)
{
    return outcome.kind == Answer::aborted &&
           (outcome.abortCode == abort_code::noObject || outcome.abortCode == abort_code::noSubindex);
}

} // namespace

void NodeJob::answered(const SdoOutcome &outcome, Instant now)
{
    m_isUnderWay = false;
    if (isDone())
        return;
    const NodeStep &step = m_steps.current();
    if (outcome.kind == Answer::notSent)
        fail({RefusalKind::link,
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
        for (const ParameterDescription &its : m_encoder.device.parameters)
            if (its.canBeWritten)
                m_encoder.values.forget(its.parameter);
        m_encoder.takeCams({});
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

// A device that has no command to store keeps what it keeps.
void NodeJob::aborted(const SdoOutcome &outcome)
{
    const Task task = m_steps.current().task;
    if (task == Task::store && isMissing(outcome)) {
        m_encoder.values.mayHaveBeenStored();
        m_steps.goOn();
    } else if (!stopsForIt(outcome)) {
        fail(refusalOf(outcome));
    }
}

// It was refused because of the state of the node, so it was not carried out, and may be sent again.
bool NodeJob::stopsForIt(const SdoOutcome &outcome)
{
    const bool mayRun = m_encoder.state().value_or(NmtState::operational) == NmtState::operational;
    if (outcome.abortCode != abort_code::wrongState || !mayRun)
        return false;
    if (!m_mayStop) {
        fail({RefusalKind::busy, CanopenRefusalId::nodeWouldStop, {std::int64_t{m_encoder.node}}});
        return true;
    }
    m_startsAgain = true;
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
        constexpr int turned = 2; // steps, of a shaft at rest
        const auto isNear = [&](std::int64_t position) {
            return std::abs(std::int64_t{static_cast<std::int32_t>(*outcome.positionAfter - position)}) <=
                   turned;
        };
        const bool isNearWanted = isNear(wanted);
        const bool isNearBefore = isNear(*outcome.positionBefore);
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

void NodeJob::fail(Refusal why)
{
    m_unanswered.reset();
    noteFailure(std::move(why));
}

Refusal NodeJob::refusalOf(const SdoOutcome &outcome) const
{
    const QString object = m_steps.current().object.text();
    if (outcome.kind == Answer::aborted && !outcome.isOwnAbort)
        return {RefusalKind::device, CanopenRefusalId::sdoAborted, {object, Word{outcome.abortCode}}};
    return {RefusalKind::device, CanopenRefusalId::sdoNoAnswer, {object, std::int64_t{m_encoder.node}}};
}

} // namespace codewheel::canopen
