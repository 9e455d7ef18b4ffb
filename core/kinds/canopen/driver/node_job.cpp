// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/driver/node_job.h"

#include "catalog/kept_values.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {

bool changesSomething(const NodeStep &step)
{
    return step.effect != Effect::reads && step.effect != Effect::readsCams &&
           step.task != NodeStep::Task::bootUp && step.task != NodeStep::Task::started;
}

bool changesEncoder(const Job &job)
{
    return std::holds_alternative<WriteParameters>(job) || std::holds_alternative<SetPreset>(job) ||
           std::holds_alternative<ResetToDefault>(job) || std::holds_alternative<WriteCams>(job) ||
           std::holds_alternative<StoreParameters>(job);
}

NodeJob::NodeJob(JobId id, Job job, Pace pace, bool mayStop, NodeEncoder &encoder)
    : JobRun(id, std::move(job), pace, encoder.values, encoder.reading, encoder.events)
    , m_encoder(encoder)
    , m_mayStop(mayStop)
{
    m_steps.all = encoder.plan().stepsFor(m_job);
    m_startsAgain = JobRun::job<ResetToDefault>() != nullptr && encoder.mayRun();
    if (const auto *write = JobRun::job<WriteCams>();
        write != nullptr && encoder.cams && !write->onlyWhatDiffers)
        m_camsGiven = encoder.cams->program;
}

std::optional<NodeRequest> NodeJob::next(Instant now)
{
    settle();
    while (waitsForNode()) {
        if (!(m_steps.current().task == Task::bootUp ? isBackAfterReset(now) : isStarted(now)))
            return std::nullopt;
        settle();
    }
    if (isDone())
        return std::nullopt;
    if (!m_steps.begun && changesSomething(m_steps.current()) && !goesByItself()) {
        ask();
        return std::nullopt;
    }
    begin(now);
    m_isUnderWay = true;
    return requestOf(m_steps.current());
}

void NodeJob::begin(Instant now)
{
    beginStep();
    m_begunAt = now;
    reportProgress(false);
}

// The boot-up may come before the command was reported as sent.
bool NodeJob::isBackAfterReset(Instant now)
{
    const Instant reset = m_begunAt;
    m_steps.begun = true;
    if (m_encoder.bootedAt && *m_encoder.bootedAt >= reset) {
        m_steps.goOn();
        return true;
    }
    if (now < reset + m_encoder.settings.longTimeOut)
        return false;
    fail({RefusalKind::device,
          CanopenRefusalId::notBackAfterReset,
          {std::int64_t{m_encoder.node},
           std::int64_t{
               std::chrono::duration_cast<std::chrono::seconds>(m_encoder.settings.longTimeOut).count()}}});
    m_startsAgain = false;
    return true;
}

// Nobody answers the command.
bool NodeJob::isStarted(Instant now)
{
    const auto shown = m_encoder.watch.state();
    if (shown == NmtState::operational) {
        m_steps.goOn();
        return true;
    }
    if (now < m_begunAt + m_encoder.settings.startTimeOut)
        return false;
    fail({RefusalKind::device,
          shown ? CanopenRefusalId::notStartedAgain : CanopenRefusalId::startNotSeen,
          {std::int64_t{m_encoder.node}}});
    return true;
}

bool NodeJob::waitsForNode() const
{
    if (isDone() || m_steps.atEnd())
        return false;
    const Task task = m_steps.current().task;
    return task == Task::bootUp || task == Task::started;
}

std::optional<Instant> NodeJob::waitsUntil() const
{
    if (!waitsForNode())
        return std::nullopt;
    return m_begunAt + (m_steps.current().task == Task::bootUp ? m_encoder.settings.longTimeOut
                                                               : m_encoder.settings.startTimeOut);
}

bool NodeJob::mayBeSilent() const
{
    if (isDone() || m_steps.atEnd() || !m_steps.begun)
        return false;
    const Task task = m_steps.current().task;
    return task == Task::store || task == Task::restore || task == Task::bootUp || task == Task::nmt;
}

// What follows once steps are done: further steps, or the end.
void NodeJob::settle()
{
    if (isDone())
        return;
    const bool hasCompared =
        m_steps.atEnd() || (m_steps.current().task != Task::read && m_steps.current().task != Task::readCam);
    if (hasCompared && !std::exchange(m_isCompared, true)) {
        leaveOutWhatIsThere();
        leaveOutCamsThatAreThere();
    }
    if (std::exchange(m_hasBooted, false))
        endAtRestart();
    if (hasLeftOffNow())
        goOnAfterCancel();
    if (m_steps.atEnd() && std::exchange(m_startsAgain, false))
        m_steps.append({NodePlan::nmt(NmtCommand::start), NodePlan::started()});
    if (!m_steps.atEnd())
        return;
    const bool hasNothing = m_missing && !m_failure && m_account.outcome.read.empty();
    if (hasNothing && job<ReadParameters>() != nullptr)
        m_failure = m_missing;
    finish(result());
}

void NodeJob::nodeHasBooted()
{
    const auto written = [](const NodeStep &step) {
        return changesSomething(step) && step.task != Task::nmt;
    };
    const bool isWriting = m_isUnderWay && written(m_steps.current());
    const bool isExpected = mayBeSilent() || (!m_steps.atEnd() && m_steps.current().task == Task::bootUp);
    m_hasBooted = !isExpected && (isWriting || std::ranges::any_of(m_steps.done(), written));
}

// What was written since it was last stored may be lost, or there all the same.
void NodeJob::endAtRestart()
{
    if (m_unanswered)
        noteDoubt(*m_unanswered, m_account.outcome.inDoubt);
    const auto done = m_steps.done();
    const auto stored = std::ranges::find(done.rbegin(), done.rend(), Task::store, &NodeStep::task);
    doubtDone({stored.base(), done.end()});
    fail({RefusalKind::device, CanopenRefusalId::nodeRestarted, {std::int64_t{m_encoder.node}}});
}

// What is in force already, and perhaps not stored, is stored with the rest.
void NodeJob::leaveOutWhatIsThere()
{
    const auto *write = job<WriteParameters>();
    if (write == nullptr || !write->onlyWhatDiffers || m_failure || m_cancelled)
        return;
    ParameterValues left;
    for (const ParameterValue &value : write->values)
        (findValue(m_account.outcome.read, value.parameter) != value.value ? left
         : mayBeLost(value)                                                ? m_toStore
                                                                           : m_account.outcome.alreadyThere)
            .push_back(value);
    m_steps.dropRest();
    m_steps.append(left.empty() && !m_toStore.empty() ? NodeSteps{NodePlan::store()}
                                                      : m_encoder.plan().writes(left));
}

bool NodeJob::mayBeLost(const ParameterValue &value) const
{
    const auto known = m_encoder.values.known(value.parameter);
    return !known || hasToBeStored(m_encoder.device, *known);
}

void NodeJob::leaveOutCamsThatAreThere()
{
    const bool isRead = job<ReadCams>() != nullptr;
    const auto *write = job<WriteCams>();
    const bool compares = write != nullptr && write->onlyWhatDiffers;
    if ((!isRead && !compares) || m_failure || m_cancelled)
        return;
    m_account.outcome.camsRead = {m_camsRead};
    m_encoder.takeCams(KnownCams{m_camsRead, Evidence::read, m_begunAt});
    m_steps.dropRest();
    if (!compares)
        return;
    m_camsGiven = m_camsRead;
    for (const CamProgram &program : write->programs)
        m_steps.append(m_encoder.plan().cams(program, m_camsRead));
}

NodeRequest NodeJob::requestOf(const NodeStep &step) const
{
    if (step.task == Task::nmt)
        return NmtRequest{step.command, m_encoder.node};
    SdoRequest request{.node = m_encoder.node, .object = step.object, .timeOut = m_encoder.settings.timeOut};
    const auto number = [&] {
        return octetsOf(Value(std::int64_t{step.number}), m_encoder.widthOf(step.object));
    };
    switch (step.task) {
    case Task::write:
        request.value = bitsOf(step);
        break;
    case Task::preset:
        request.timeOut = m_encoder.settings.longTimeOut;
        request.value = number();
        break;
    case Task::writeCam:
        request.value = number();
        break;
    case Task::store:
    case Task::restore:
        request.timeOut = m_encoder.settings.longTimeOut;
        request.value = octetsOf(Value(std::int64_t{step.number}), sizeof(step.number));
        break;
    default:
        break;
    }
    return request;
}

// The value, or the bits of it between those that stay as they were read.
std::vector<std::uint8_t> NodeJob::bitsOf(const NodeStep &step) const
{
    const std::size_t width = m_encoder.widthOf(step.object);
    std::int64_t whole = m_whole.number();
    for (const ParameterValue &value : step.values) {
        const CanopenReach *reach = canopenReach(*m_encoder.device.find(value.parameter));
        if (!reach->bit)
            return octetsOf(value.value, width);
        const std::int64_t mask = std::int64_t{1} << *reach->bit;
        whole = value.value.number() != 0 ? whole | mask : whole & ~mask;
    }
    return octetsOf(Value(whole), width);
}

void NodeJob::complete(Outcome &outcome)
{
    if (hasRestored())
        outcome.restored = Evidence::read;                                  // like everything that is written
    std::ranges::copy(m_toStore, std::back_inserter(outcome.alreadyThere)); // they were not stored
    m_encoder.flush();
}

} // namespace codewheel::canopen
