// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_refusal.h"

#include "kinds/interbus/k3/k3_reading.h"
#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/word_refusals.h"

namespace codewheel {
namespace {

constexpr unsigned wrongData = 1;
constexpr unsigned wrongCommand = 2;
constexpr unsigned lost = 3;
constexpr Word aboveLargestPosition = 0x9800'0004;

std::optional<Refusal> camRefusal(const K3Circumstances &at, Word in)
{
    const K3Step &step = at.step;
    const unsigned number = k3::number(in);
    if (at.foundParameterizing && onlyAsksForCams(step) && number == wrongCommand)
        return Refusal{RefusalKind::device, WordRefusalId::camsInParameterization, {step.out, in}};
    if (k3::isCamReadOutRequest(step.out)) {
        if (stateOf(in, at.device.dialect.as<k3::Dialect>()) == EncoderState::readOut ||
            number == wrongCommand)
            return Refusal{RefusalKind::device, WordRefusalId::readOutUnknown, {step.out, in}};
        return std::nullopt;
    }
    const bool inCamMode = step.kind == StepKind::camParameter || step.inCamMode || at.inCamMode;
    const auto field = inCamMode ? fieldSetBy(step.out) : std::nullopt;
    if (field && in == aboveLargestPosition)
        return Refusal{
            RefusalKind::device, WordRefusalId::camPositionAboveRange, {std::int64_t{field->cam}, in}};
    if (at.device.capabilities.cams && in == aboveLargestPosition)
        return Refusal{RefusalKind::device, WordRefusalId::camPositionAboveRange, {in}};
    const bool wasAsked = inCamMode && step.out != k3::normalRunning;
    if ((wasAsked || k3::isProgramWord(step.out)) && (number == wrongData || number == wrongCommand))
        return Refusal{RefusalKind::device, WordRefusalId::camWordRefused, {step.out, in}};
    if (inCamMode && number == lost)
        return Refusal{RefusalKind::device, WordRefusalId::lostInCamMode, {in}};
    return std::nullopt;
}

// An error before the word was confirmed may be about the previous word; an error at run is about the set,
// and that of an encoder found in an error may have values of before the job.
std::vector<RefusalArgument> suspects(const K3Circumstances &at)
{
    std::vector<RefusalArgument> suspects;
    const K3Step &step = at.step;
    if (k3::isParameterWord(step.out)) {
        if (!at.isConfirmed && !at.confirmed.empty())
            suspects.emplace_back(at.confirmed.back().parameter);
        if (step.parameter())
            suspects.emplace_back(*step.parameter());
        else
            suspects.emplace_back(std::int64_t{k3::number(step.out)});
        return suspects;
    }
    if (at.foundInError)
        return {};
    for (const ParameterValues *taken : {&at.confirmed, &at.written})
        for (const ParameterValue &value : *taken)
            suspects.emplace_back(value.parameter);
    return suspects;
}

} // namespace

Refusal k3Refusal(const K3Circumstances &at, Word in)
{
    if (auto aboutCams = camRefusal(at, in))
        return *std::move(aboutCams);
    if (at.step.kind == StepKind::readOut || k3::isReadOutRequest(at.step.out)) {
        if (stateOf(in, at.device.dialect.as<k3::Dialect>()) == EncoderState::readOut)
            return {
                RefusalKind::device, WordRefusalId::readOutUnknown, {std::int64_t{at.step.out & 0xFFFF}, in}};
    }
    const unsigned number = k3::number(in);
    const DeviceError *error = at.device.findError(number);
    const RefusalCode id = error != nullptr ? error->meaning : RefusalId::otherDeviceError;
    std::vector<RefusalArgument> arguments;
    if (id == RefusalId::wrongParameterData || id == RefusalId::unknownParameterNumber)
        arguments = suspects(at);
    else if (id == RefusalId::manufacturerError)
        arguments = {std::int64_t{in & 0xFF}};
    else if (id == RefusalId::otherDeviceError)
        arguments = {std::int64_t{number}};
    if (id == RefusalId::unknownParameterNumber && at.mayBeInCamMode && k3::isParameterWord(at.step.out))
        arguments.emplace_back(at.step.out);
    arguments.emplace_back(in);
    return {RefusalKind::device, id, std::move(arguments)};
}

bool onlyAsksForCams(const K3Step &step)
{
    return step.kind == StepKind::camReadOut ||
           (step.kind == StepKind::switchMode && k3::isProgramWord(step.out));
}

} // namespace codewheel
