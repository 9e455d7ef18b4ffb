// SPDX-License-Identifier: GPL-3.0-or-later
// How a job ends before its end: by the user, by a restart of the encoder, by what comes late.
#include "drivers/k3_driver.h"

#include <algorithm>

namespace codewheel {
namespace {

// The value a step gives the encoder, where it is one of a parameter that the description names.
std::optional<ParameterValue> valueGivenBy(const K3Step &step)
{
    if (!step.parameter)
        return std::nullopt;
    if (step.kind == StepKind::parameter)
        return ParameterValue{*step.parameter, step.value};
    if (step.kind == StepKind::word)
        return ParameterValue{*step.parameter, k3::data(step.out)};
    return std::nullopt;
}

bool mayBeTaken(const K3Step &step)
{
    return step.kind == StepKind::parameter || step.kind == StepKind::camParameter ||
           (step.kind == StepKind::word &&
            (k3::isParameterWord(step.out) || (step.inCamMode && fieldSetBy(step.out))));
}

bool resetsToDefault(const Job &job)
{
    const auto *send = std::get_if<SendWords>(&job);
    return std::holds_alternative<ResetToDefault>(job) ||
           (send && std::ranges::any_of(send->words, [](Word word) {
                return k3::isParameterWord(word) && k3::number(word) == resetNumber;
            }));
}

} // namespace

void K3Driver::cancel(OnCancel how, Instant now)
{
    if (!m_run || m_run->cancelled || m_run->failure)
        return;
    Run &run = *m_run;
    if (how == OnCancel::ifNothingTaken && hasTaken()) {
        reportProgress(run.asked && !run.mayBegin);
        return;
    }
    run.cancelled = how;
    run.cancelledAt = now;
    if (const auto value = run.begun ? valueGivenBy(current()) : std::nullopt) {
        if (m_handshake.hasConfirmed())
            replaceValue(run.confirmed, *value);
        else
            run.inFlight = current();
    }
    if (run.begun && current().kind == StepKind::camParameter)
        run.inFlight = current();
    const bool runIsOnItsWay = run.begun && current().kind == StepKind::run;
    if (runIsOnItsWay) // cannot be taken back: its answer is waited for
        ++run.index;
    run.steps.resize(run.index);
    run.steps.push_back(K3Plan::toNormal(false));
    if (runIsOnItsWay)
        --run.index;
    else
        run.begun = false;
}

// A word that stands in OUT may be taken, whether it was confirmed or not.
bool K3Driver::hasTaken() const
{
    const Run &run = *m_run;
    const auto sent = run.steps.begin() + static_cast<std::ptrdiff_t>(
                                              std::min(run.steps.size(), run.index + (run.begun ? 1 : 0)));
    const bool isOnlyRead = std::holds_alternative<ReadParameters>(run.job);
    return (m_reading.state == EncoderState::parameterization && !isOnlyRead) || !run.confirmed.empty() ||
           !run.written.empty() || !run.cams.taken.empty() ||
           std::any_of(run.steps.begin(), sent, mayBeTaken);
}

// Only run ends a parameterization. An encoder that is in operation before run was sent has started anew, and
// dropped what it had confirmed.
void K3Driver::lookForRestart(Word in)
{
    Run &run = *m_run;
    const bool isBegun = run.begun && run.index < run.steps.size();
    const bool hasConfirmed =
        !run.confirmed.empty() || run.resetConfirmed || run.cams.isPending ||
        (isBegun && current().kind == StepKind::parameter && m_handshake.hasConfirmed());
    const bool runIsSent = isBegun && current().out == k3::run;
    if (!hasConfirmed || runIsSent || !k3::isOperation(in))
        return;
    run.confirmed.clear();
    run.resetConfirmed = false;
    dropCams();
    const bool dropsAnyway = run.cancelled && !run.cancelPlanned;
    if (!std::holds_alternative<SendWords>(run.job) && !dropsAnyway && !run.failure)
        fail(restarted(in));
}

// What was on its way as the job was cancelled may still be confirmed.
void K3Driver::lookForLateAnswer(Word in)
{
    Run &run = *m_run;
    if (!run.cancelled || run.cancelPlanned)
        return;
    if (run.inFlight && run.inFlight->kind == StepKind::camParameter) {
        if (in == (run.inFlight->out | k3::confirmation))
            camWordTaken(run.inFlight->out);
        else if (!isErrorAnswer(in, m_device.dialect)) // in place of the acknowledgement
            return;
        run.inFlight.reset();
    } else if (run.inFlight && k3::isConfirmation(in) && k3::number(in) == k3::number(run.inFlight->out)) {
        replaceValue(run.confirmed, *valueGivenBy(*run.inFlight));
        run.inFlight.reset();
    }
}

// Baumer: the new data beside the number from before. FRABA shows nothing of a cam word before it is
// acknowledged.
bool K3Driver::isStillProcessing(Word in, Instant now) const
{
    const Run &run = *m_run;
    if (run.inFlight && run.inFlight->kind == StepKind::camParameter)
        return now - run.cancelledAt < m_timing.timeOut;
    return run.cancelled && !run.cancelPlanned && run.inFlight && k3::isConfirmation(in) &&
           k3::data(in) == k3::data(run.inFlight->out) && now - run.cancelledAt < m_timing.timeOut;
}

// OUT is 0 again. Where the encoder has taken something, the user's choice follows.
void K3Driver::appendCancelSteps(Word in)
{
    Run &run = *m_run;
    run.cancelPlanned = true;
    const bool parameterizing = stateOf(in, m_device.dialect) == EncoderState::parameterization;
    const bool ranMeanwhile = !run.written.empty() || !run.cams.taken.empty();
    K3Steps steps;
    if (*run.cancelled == OnCancel::runWithWhatItHas && parameterizing)
        steps = m_plan.endParameterization({}, true);
    else if (*run.cancelled == OnCancel::restorePrevious && canRestore() && (parameterizing || ranMeanwhile))
        steps = stepsToRestore(parameterizing);
    run.steps.insert(run.steps.end(), steps.begin(), steps.end());
}

// What was written and read back until now does not hold any more.
K3Steps K3Driver::stepsToRestore(bool parameterizing)
{
    Run &run = *m_run;
    run.restores = !run.cams.taken.empty() || !run.written.empty() || !run.confirmed.empty();
    run.mismatch.reset();
    run.cams.written.clear();
    return run.cams.taken.empty() ? m_plan.endParameterization(valuesToRestore(), parameterizing)
                                  : stepsToRestoreCams();
}

bool K3Driver::canRestore() const
{
    if (resetsToDefault(m_run->job))
        return false; // run would carry out the reset
    const auto isKnown = [this](const ParameterValue &value) {
        return valueOf(m_run->before, value.parameter).has_value();
    };
    return std::ranges::all_of(m_run->confirmed, isKnown) && std::ranges::all_of(m_run->written, isKnown) &&
           m_run->cams.canRestore();
}

ParameterValues K3Driver::valuesToRestore() const
{
    ParameterValues values;
    for (const ParameterValues *taken : {&m_run->written, &m_run->confirmed})
        for (const ParameterValue &value : *taken)
            replaceValue(values, {value.parameter, *valueOf(m_run->before, value.parameter)});
    return values;
}

} // namespace codewheel
