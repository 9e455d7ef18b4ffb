// SPDX-License-Identifier: GPL-3.0-or-later
// The cam jobs on their way (FRABA manual 5.4.4).
#include "drivers/k3_cam_plan.h"
#include "drivers/k3_driver.h"
#include "words/k3_cam_word.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr unsigned wrongData = 1;
constexpr unsigned wrongCommand = 2;
constexpr unsigned lost = 3;
constexpr Word aboveLargestPosition = 0x9800'0004;

} // namespace

void K3Driver::camReadOutDone(const K3Step &step, Word in)
{
    Run &run = *m_run;
    const CamField field = *fieldReadBy(step.out);
    CamProgram told{.number = step.camProgram, .cam = {}, .shift = 0};
    setValue(told, field, k3::data(in)); // active cams without the bits that belong to none
    if (!step.expected) {
        run.cams.tell(step.camProgram, field, k3::data(in));
    } else if (valueOf(told, field) != *step.expected && !run.mismatch) {
        run.mismatch = {
            RefusalKind::device, RefusalId::camVerificationFailed, {std::int64_t{step.camProgram}}};
    }
}

// With the last read-out of a program follows what is to be written to it, or its verification is complete.
void K3Driver::camReadOutEnded(const K3Step &step)
{
    Run &run = *m_run;
    const bool readsOn = run.index < run.steps.size() && current().kind == StepKind::camReadOut &&
                         current().camProgram == step.camProgram &&
                         current().expected.has_value() == step.expected.has_value();
    const auto *job = std::get_if<WriteCams>(&run.job);
    if (step.camProgram == 0 || readsOn || job == nullptr || run.failure || run.cancelled)
        return;
    if (!step.expected) {
        if (job->onlyWhatDiffers)
            planWrite(run.cams.read.back());
    } else if (run.mismatch) {
        fail(*run.mismatch);
    } else {
        run.cams.written.push_back(*std::ranges::find(job->programs, step.camProgram, &CamProgram::number));
    }
}

// Only what differs from what the encoder has now.
void K3Driver::planWrite(const CamProgram &now)
{
    Run &run = *m_run;
    const auto &job = std::get<WriteCams>(run.job);
    const auto rest = [&] { return run.steps.begin() + static_cast<std::ptrdiff_t>(run.index); };
    const auto isFollowing = [&](const K3Step &step) {
        return step.writesCams && step.camProgram == now.number;
    };
    const auto end = std::find_if_not(rest(), run.steps.end(), isFollowing);
    run.steps.erase(rest(), end);

    const CamProgram &wanted = *std::ranges::find(job.programs, now.number, &CamProgram::number);
    const bool isLast =
        std::none_of(rest(), run.steps.end(), [](const K3Step &step) { return step.camProgram != 0; });
    const bool saves = isLast && job.afterwards == SwitchMode{Mode::cam, now.number};
    const K3Steps steps = K3CamPlan::write(wanted, differences(now, wanted), saves);
    run.steps.insert(rest(), steps.begin(), steps.end());
}

void K3Driver::camWordTaken(Word out)
{
    if (const auto program = m_knowledge.camProgram())
        m_run->cams.take(*program, *fieldSetBy(out));
}

// Without its power the encoder has lost what was acknowledged since it entered the program.
void K3Driver::dropCams()
{
    K3CamRecord &cams = m_run->cams;
    if (!cams.isPending)
        return;
    cams.isPending = false;
    if (const auto program = m_knowledge.camProgram())
        cams.taken.erase(*program);
}

// What was written and read back may be lost until its program is left. With the cams only, 00000000h in IN
// is no sign of that.
Result<void> K3Driver::checkCams(Word in)
{
    const auto isLost = [this](const CamProgram &program) {
        const auto known = m_knowledge.cams(program.number);
        return program.shift != CamProgram::largestShift && (!known || known->program != program);
    };
    if (std::erase_if(m_run->cams.written, isLost) != 0)
        return tl::unexpected(restarted(in));
    return {};
}

// The program the encoder is in first: what it has there is not saved yet.
K3Steps K3Driver::stepsToRestoreCams() const
{
    const auto current = m_knowledge.camProgram();
    K3Steps steps;
    const auto append = [&](unsigned program, CamFieldSet fields) {
        const K3Steps one = K3CamPlan::restore(m_run->cams.before.at(program), fields, program != current);
        steps.insert(steps.end(), one.begin(), one.end());
    };
    for (const auto &[program, fields] : m_run->cams.taken)
        if (program == current)
            append(program, fields);
    for (const auto &[program, fields] : m_run->cams.taken)
        if (program != current)
            append(program, fields);
    return steps;
}

// The words that only ask whether the encoder understands cams.
bool K3Driver::onlyAsksForCams() const
{
    const K3Step &step = current();
    return step.kind == StepKind::camReadOut ||
           (step.kind == StepKind::switchMode && k3::isProgramWord(step.out));
}

// Run ends the error. Where the encoder was in a parameterization before, it would make valid what others
// have sent.
bool K3Driver::bringsBack(Word in) const
{
    return onlyAsksForCams() && isErrorAnswer(in, m_device.dialect) && !m_run->foundParameterizing;
}

void K3Driver::failAt(Word in)
{
    const bool isOurOwn = bringsBack(in) && !m_run->failure;
    fail(refusalFor(in));
    if (!isOurOwn)
        return;
    m_run->steps.push_back(K3Plan::runStep(true));
    m_run->steps.push_back(K3Plan::toNormal(false));
}

std::optional<Refusal> K3Driver::camRefusalFor(Word in) const
{
    const K3Step &step = current();
    const unsigned number = k3::number(in);
    if (m_run->foundParameterizing && onlyAsksForCams() && number == wrongCommand)
        return Refusal{RefusalKind::device, RefusalId::camsInParameterization, {step.out, in}};
    if (k3::isCamReadOutRequest(step.out)) {
        if (stateOf(in, m_device.dialect) == EncoderState::readOut || number == wrongCommand)
            return Refusal{RefusalKind::device, RefusalId::readOutUnknown, {step.out, in}};
        return std::nullopt;
    }
    const bool inCamMode =
        step.kind == StepKind::camParameter || step.inCamMode || m_knowledge.mode() == Mode::cam;
    const auto field = inCamMode ? fieldSetBy(step.out) : std::nullopt;
    if (field && in == aboveLargestPosition)
        return Refusal{RefusalKind::device, RefusalId::camPositionAboveRange, {std::int64_t{field->cam}, in}};
    if (m_device.capabilities.cams && in == aboveLargestPosition)
        return Refusal{RefusalKind::device, RefusalId::camPositionAboveRange, {in}};
    const bool wasAsked = inCamMode && step.out != k3::normalRunning;
    if ((wasAsked || k3::isProgramWord(step.out)) && (number == wrongData || number == wrongCommand))
        return Refusal{RefusalKind::device, RefusalId::camWordRefused, {step.out, in}};
    if (inCamMode && number == lost)
        return Refusal{RefusalKind::device, RefusalId::lostInCamMode, {in}};
    return std::nullopt;
}

} // namespace codewheel
