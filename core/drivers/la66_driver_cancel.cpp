// SPDX-License-Identifier: GPL-3.0-or-later
// How a job ends before its end. A service that was asked for cannot be taken back: it is waited for, and its
// handshake is finished.
#include "drivers/la66_driver.h"
#include "words/la66_word.h"

#include <algorithm>

namespace codewheel {

void La66Driver::cancel(OnCancel how, Instant)
{
    if (!m_run || m_run->cancelled || m_run->failure)
        return;
    Run &run = *m_run;
    if (how == OnCancel::ifNothingTaken && hasTaken()) {
        reportProgress(run.asked && !run.mayBegin);
        return;
    }
    run.cancelled = how;
    if (!run.prepared)
        return; // nothing was sent
    const bool isAsked = run.begun && current().kind == StepKind::serviceBit;
    const std::size_t kept = run.index + (isAsked ? 1 : 0);
    run.begun = isAsked;
    run.steps.resize(kept);
    const La66Steps back = La66Plan::wayBack(m_out);
    run.steps.insert(run.steps.end(), back.begin(), back.end());
}

// A service that was asked for is carried out, whether it was acknowledged or not.
bool La66Driver::hasTaken() const
{
    const Run &run = *m_run;
    const auto asked = run.steps.begin() + static_cast<std::ptrdiff_t>(
                                               std::min(run.steps.size(), run.index + (run.begun ? 1 : 0)));
    return !run.written.empty() || std::any_of(run.steps.begin(), asked, [](const La66Step &step) {
        return step.kind == StepKind::serviceBit && la66::isWrite(step.out);
    });
}

// OUT is 0 again. What the job has written goes back where that was asked for and the old values are known.
void La66Driver::appendRestore()
{
    Run &run = *m_run;
    run.cancelPlanned = true;
    if (*run.cancelled != OnCancel::restorePrevious || run.written.empty() || !canRestore())
        return;
    run.restores = true;
    ParameterValues values;
    for (const ParameterValue &taken : run.written)
        values.push_back({taken.parameter, *valueOf(run.before, taken.parameter)});
    for (const La66Steps &steps : {m_plan.writes(values), La66Plan::wayBack(la66::normalMode)})
        run.steps.insert(run.steps.end(), steps.begin(), steps.end());
}

bool La66Driver::canRestore() const
{
    return std::ranges::all_of(m_run->written, [this](const ParameterValue &value) {
        return valueOf(m_run->before, value.parameter).has_value();
    });
}

} // namespace codewheel
