// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_cam_plan.h"

#include "cams/check_cams.h"
#include "catalog/total_range.h"
#include "jobs/job_check.h"
#include "kinds/interbus/words/k3_cam_word.h"

#include <algorithm>
#include <set>

namespace codewheel {
namespace {

constexpr CamField shiftField{CamValue::shift};
constexpr CamField activeField{CamValue::activeCams};

void appendReadOut(K3Steps &steps, unsigned program, CamField field,
                   std::optional<std::int64_t> expected = {})
{
    K3Step read = k3Step(StepKind::camReadOut, readOutWord(field));
    read.camProgram = program;
    read.expected = expected;
    K3Step end = k3Step(StepKind::endReadOut, k3::normalRunning);
    end.camProgram = program;
    end.expected = expected;
    steps.push_back(read);
    steps.push_back(end);
}

// The configuration first: it is the read-out that distinguishes cam mode from the others.
void appendReadOuts(K3Steps &steps, unsigned program)
{
    appendReadOut(steps, program, activeField);
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (camField(i) != activeField)
            appendReadOut(steps, program, camField(i));
}

// 40000000, 60000000 and 2040000x would do something else outside cam mode.
bool hasAnotherMeaning(Word out)
{
    return out == k3::initialisePreset || out == k3::frabaPreset || out == k3::velocityOn ||
           out == k3::velocityOff;
}

void appendSetting(K3Steps &steps, const CamProgram &program, CamField field)
{
    K3Step step = k3Step(StepKind::camParameter, settingWord(field, valueOf(program, field)));
    step.camProgram = program.number;
    steps.push_back(step);
}

std::optional<CamField> firstOf(CamFieldSet fields)
{
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (fields[i])
            return camField(i);
    return std::nullopt;
}

// The first word opens the cam parameterization, which shows in IN from then on until power-off or run. If
// that word would have another meaning, shift_iw goes out before it.
void appendSettings(K3Steps &steps, const CamProgram &program, CamFieldSet fields)
{
    const auto first = firstOf(fields);
    if (!first)
        return;
    if (hasAnotherMeaning(settingWord(*first, valueOf(program, *first)))) {
        appendSetting(steps, program, shiftField);
        fields.reset(indexOf(shiftField));
    }
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (fields[i])
            appendSetting(steps, program, camField(i));
    steps.push_back(K3Plan::runStep(false));
    steps.push_back(K3Plan::toNormal(true));
}

void appendReadBack(K3Steps &steps, const CamProgram &program, CamFieldSet fields)
{
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (fields[i])
            appendReadOut(steps, program.number, camField(i), valueOf(program, camField(i)));
}

void appendEntry(K3Steps &steps, unsigned program)
{
    steps.push_back(K3Plan::switchStep(k3::selectCamProgram(program)));
}

void appendAfterwards(K3Steps &steps, const SwitchMode &afterwards)
{
    if (afterwards.mode == Mode::cam)
        appendEntry(steps, afterwards.camProgram);
    else
        steps.push_back(K3Plan::switchStep(k3::programWord));
    if (afterwards.mode == Mode::velocity)
        steps.push_back(K3Plan::switchStep(k3::velocityOn));
    steps.push_back(K3Plan::toNormal(true));
}

} // namespace

Result<void> K3CamPlan::checkPrograms(const std::vector<unsigned> &programs,
                                      const std::optional<SwitchMode> &afterwards) const
{
    if (programs.empty())
        return refuse(RefusalKind::badInput, RefusalId::nothingToDo);
    std::set<unsigned> seen;
    for (const unsigned program : programs) {
        if (auto checked = checkCamProgramNumber(program, *m_device.capabilities.cams); !checked)
            return checked;
        if (!seen.insert(program).second)
            return refuse(RefusalKind::badInput, RefusalId::camProgramGivenTwice, {std::int64_t{program}});
    }
    return afterwards ? check(*afterwards) : Result<void>{};
}

Result<void> K3CamPlan::check(const ReadCams &job) const
{
    return checkPrograms(job.programs, job.afterwards);
}

Result<void> K3CamPlan::check(const WriteCams &job) const
{
    if (auto checked = checkPrograms(numbersOf(job.programs), job.afterwards); !checked)
        return checked;
    for (const CamProgram &program : job.programs)
        if (auto checked = codewheel::check(program, *m_device.capabilities.cams, largestPosition());
            !checked)
            return checked;
    return {};
}

Result<void> K3CamPlan::check(const SwitchMode &job) const
{
    if (auto checked = checkJob(m_device, job); !checked)
        return checked;
    return job.mode == Mode::cam ? checkCamProgramNumber(job.camProgram, *m_device.capabilities.cams)
                                 : Result<void>();
}

// Above it the encoder itself answers 98000004h.
std::int64_t K3CamPlan::largestPosition() const
{
    const auto total = totalRange(m_device, m_knowledge.values());
    return total ? std::min(*total - 1, largestCamPosition) : largestCamPosition;
}

std::vector<unsigned> K3CamPlan::currentFirst(std::vector<unsigned> programs) const
{
    const auto current = m_knowledge.camProgram();
    std::stable_partition(programs.begin(), programs.end(),
                          [&](unsigned program) { return program == current; });
    return programs;
}

CamFieldSet K3CamPlan::fieldsToWrite(const CamProgram &program, bool onlyWhatDiffers) const
{
    const auto known = m_knowledge.cams(program.number);
    if (onlyWhatDiffers && known)
        return differences(known->program, program);
    return CamFieldSet().set();
}

K3Steps K3CamPlan::stepsFor(const ReadCams &job) const
{
    K3Steps steps;
    std::optional<unsigned> current = m_knowledge.camProgram();
    for (const unsigned program : currentFirst(job.programs)) {
        if (current != program)
            appendEntry(steps, program);
        current = program;
        appendReadOuts(steps, program);
    }
    if (job.afterwards && *job.afterwards != SwitchMode{Mode::cam, *current})
        appendAfterwards(steps, *job.afterwards);
    return steps;
}

K3Steps K3CamPlan::stepsFor(const WriteCams &job) const
{
    K3Steps steps;
    std::optional<unsigned> current = m_knowledge.camProgram();
    const std::vector<unsigned> numbers = currentFirst(numbersOf(job.programs));
    const bool endsInLast = job.afterwards == SwitchMode{Mode::cam, numbers.back()};
    for (const unsigned number : numbers) {
        const CamProgram &program = *std::ranges::find(job.programs, number, &CamProgram::number);
        if (current != number)
            appendEntry(steps, number);
        current = number;
        if (job.onlyWhatDiffers)
            appendReadOuts(steps, number);
        else
            appendReadOut(steps, number, activeField);
        const K3Steps writing = write(program, fieldsToWrite(program, job.onlyWhatDiffers),
                                      endsInLast && number == numbers.back());
        steps.insert(steps.end(), writing.begin(), writing.end());
    }
    if (job.afterwards && !endsInLast)
        appendAfterwards(steps, *job.afterwards);
    return steps;
}

K3Steps K3CamPlan::stepsFor(const SwitchMode &job) const
{
    K3Steps steps;
    appendEntry(steps, job.camProgram);
    steps.push_back(K3Plan::toNormal(true));
    return steps;
}

K3Steps K3CamPlan::write(const CamProgram &program, CamFieldSet fields, bool saves)
{
    K3Steps steps;
    appendSettings(steps, program, fields);
    appendReadBack(steps, program, fields);
    if (saves && fields.any()) {
        steps.push_back(K3Plan::switchStep(k3::programWord));
        appendAfterwards(steps, {Mode::cam, program.number});
    }
    for (K3Step &step : steps) {
        step.camProgram = program.number;
        step.writesCams = true;
    }
    return steps;
}

K3Steps K3CamPlan::restore(const CamProgram &program, CamFieldSet fields, bool enters)
{
    K3Steps steps;
    if (enters)
        appendEntry(steps, program.number);
    appendReadOut(steps, program.number, activeField);
    appendSettings(steps, program, fields);
    appendReadBack(steps, program, fields);
    return steps;
}

} // namespace codewheel
