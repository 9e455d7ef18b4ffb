// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_cam_run.h"

#include "kinds/interbus/k3/k3_cam_plan.h"
#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/word_refusals.h"

#include <algorithm>

namespace codewheel {
namespace {

const CamProgram &programOf(const WriteCams &job, unsigned number)
{
    return *std::ranges::find(job.programs, number, &CamProgram::number);
}

} // namespace

K3CamRun::K3CamRun(const K3Encoder &encoder)
    : m_encoder(encoder)
{
    for (unsigned program = 1; program <= CamProgram::programs; ++program)
        if (const auto known = encoder.knowledge.cams(program))
            m_before[program] = known->program;
}

std::optional<Refusal> K3CamRun::readOutDone(const K3Step &step, Word in)
{
    const CamField field = *fieldReadBy(step.out);
    if (!step.expected) {
        tell(step.camProgram, field, k3::data(in));
        return std::nullopt;
    }
    CamProgram told{.number = step.camProgram, .cam = {}, .shift = 0};
    setValue(told, field, k3::data(in)); // active cams without the bits that belong to none
    if (valueOf(told, field) == *step.expected)
        return std::nullopt;
    return Refusal{
        RefusalKind::device, WordRefusalId::camVerificationFailed, {std::int64_t{step.camProgram}}};
}

void K3CamRun::tell(unsigned program, CamField field, std::int64_t data)
{
    if (m_reading.number != program || m_told.all()) {
        m_reading = {.number = program, .cam = {}, .shift = 0};
        m_told.reset();
    }
    setValue(m_reading, field, data);
    m_told.set(indexOf(field));
    if (!m_told.all())
        return;
    m_read.push_back(m_reading);
    if (!m_taken.contains(program))
        m_before[program] = m_reading;
}

bool K3CamRun::readsOn(const JobSteps<K3Step> &steps, const K3Step &step)
{
    return !steps.atEnd() && steps.current().kind == StepKind::camReadOut &&
           steps.current().camProgram == step.camProgram &&
           steps.current().expected.has_value() == step.expected.has_value();
}

void K3CamRun::planWrite(JobSteps<K3Step> &steps, const WriteCams &job) const
{
    const CamProgram &now = m_read.back();
    const CamProgram &wanted = programOf(job, now.number);
    const auto isPlanned = [&](const K3Step &step) {
        return step.writesCams && step.camProgram == now.number;
    };
    steps.all.erase(steps.rest(), std::find_if_not(steps.rest(), steps.all.end(), isPlanned));
    const bool isLast =
        std::none_of(steps.rest(), steps.all.end(), [](const K3Step &step) { return step.camProgram != 0; });
    const bool saves = isLast && job.afterwards == SwitchMode{Mode::cam, now.number};
    const K3Steps write = K3CamPlan::write(wanted, differences(now, wanted), saves);
    steps.all.insert(steps.rest(), write.begin(), write.end());
}

void K3CamRun::wasVerified(const WriteCams &job, unsigned program)
{
    m_written.push_back(programOf(job, program));
}

void K3CamRun::wordTaken(Word out)
{
    if (const auto program = m_encoder.knowledge.camProgram()) {
        m_taken[*program].set(indexOf(*fieldSetBy(out)));
        m_isPending = true;
    }
}

void K3CamRun::losePending()
{
    if (!std::exchange(m_isPending, false))
        return;
    if (const auto program = m_encoder.knowledge.camProgram())
        m_taken.erase(*program);
}

bool K3CamRun::canRestore() const
{
    return std::ranges::all_of(m_taken, [this](const auto &one) { return m_before.contains(one.first); });
}

// The current program first: what it holds there is not saved yet.
K3Steps K3CamRun::stepsToRestore()
{
    m_written.clear();
    const auto current = m_encoder.knowledge.camProgram();
    K3Steps steps;
    for (const bool isCurrent : {true, false})
        for (const auto &[program, fields] : m_taken)
            if ((program == current) == isCurrent) {
                const K3Steps one = K3CamPlan::restore(m_before.at(program), fields, !isCurrent);
                steps.insert(steps.end(), one.begin(), one.end());
            }
    return steps;
}

bool K3CamRun::dropLost()
{
    const auto isLost = [this](const CamProgram &program) {
        const auto known = m_encoder.knowledge.cams(program.number);
        return program.shift != CamProgram::largestShift && (!known || known->program != program);
    };
    return std::erase_if(m_written, isLost) != 0;
}

std::vector<CamProgram> K3CamRun::programsBefore() const
{
    std::vector<CamProgram> programs;
    for (const auto &[program, fields] : m_taken)
        programs.push_back(m_before.at(program));
    return programs;
}

} // namespace codewheel
