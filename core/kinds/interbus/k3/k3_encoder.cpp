// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_encoder.h"

#include "jobs/position_scale.h"
#include "kinds/interbus/words/word_refusals.h"

#include <utility>

namespace codewheel {
namespace {

// 2080000p ends a cam parameterization, but not one of parameters.
bool isAboutCams(const Job &job)
{
    const auto *to = std::get_if<SwitchMode>(&job);
    return std::holds_alternative<ReadCams>(job) || std::holds_alternative<WriteCams>(job) ||
           (to != nullptr && to->mode == Mode::cam);
}

bool isStartedInOperation(const Job &job)
{
    const auto *to = std::get_if<SwitchMode>(&job);
    return std::holds_alternative<WriteParameters>(job) || std::holds_alternative<SetPreset>(job) ||
           std::holds_alternative<ResetToDefault>(job) || (to != nullptr && to->mode == Mode::velocity);
}

// The values of the job. In cam mode their words are wrong commands (FRABA manual 10.6).
ParameterValues valuesOf(const Job &job)
{
    if (const auto *write = std::get_if<WriteParameters>(&job))
        return write->values;
    const auto *end = std::get_if<EndParameterization>(&job);
    return end != nullptr ? end->restore : ParameterValues{};
}

// The word of the job that sets something else in cam mode (FRABA manual 10.2 and 10.5).
std::optional<Word> wordOfTwoMeanings(const Job &job)
{
    if (const auto *preset = std::get_if<SetPreset>(&job))
        return preset->command == PresetCommand::manufacturer ? k3::frabaPreset : k3::initialisePreset;
    if (const auto *to = std::get_if<SwitchMode>(&job); to != nullptr && to->mode == Mode::velocity)
        return k3::velocityOn;
    return initialisesPreset(job) ? std::optional(k3::initialisePreset) : std::nullopt;
}

} // namespace

K3Encoder::K3Encoder(const DeviceDescription &description, K3Timing how)
    : device(description)
    , timing(how)
    , knowledge(device)
    , plan(device, knowledge)
{}

void K3Encoder::forget()
{
    knowledge.forget();
    updateScale();
}

void K3Encoder::setKnown(const std::vector<Known> &known)
{
    knowledge.set(known);
    updateScale();
}

void K3Encoder::updateScale()
{
    m_speed.setScale(
        speedScaleOf(device, [this](Parameter parameter) { return knowledge.value(parameter); }));
}

void K3Encoder::countStanding()
{
    knowledge.countStanding();
    reportChanges();
}

void K3Encoder::reportChanges()
{
    auto changes = knowledge.takeChanges();
    if (!changes)
        return;
    events.emplace_back(std::move(*changes));
    updateScale();
}

int K3Encoder::loseSight(Word out)
{
    const int perhaps = knowledge.loseSight(out, K3Knowledge::SentBy::job);
    reportChanges();
    return perhaps;
}

void K3Encoder::loseSightByHand(Word out)
{
    InDoubt doubt = knowledge.inDoubtWith(out);
    (void)knowledge.loseSight(out, K3Knowledge::SentBy::hand);
    reportChanges();
    if (doubt.hasSomething())
        events.emplace_back(std::move(doubt));
}

void K3Encoder::read(Word in, Instant now)
{
    reading = decodeReading(in, now,
                            {device.dialect.as<k3::Dialect>(), device.mayHaveModes(), knowledge.mode(),
                             knowledge.coding(), knowledge.camProgram()});
}

void K3Encoder::doubtMode()
{
    knowledge.doubtMode(reading.at);
    read(reading.in, reading.at);
    reportChanges();
}

// The jump of the position at a preset is not a movement of the shaft.
void K3Encoder::observe(Word in, Word out, Instant now)
{
    knowledge.observe(in, out, now);
    reportChanges();
    read(in, now);
    const bool isSetting = (out & k3::presetBit) != 0;
    reading.stepsPerSecond = m_speed.after(isSetting ? std::nullopt : reading.position, now);
    reading.mayMissTurns = m_speed.mayMissTurns();
    const auto shown = reading.position.value_or(k3::data(in)); // of an unknown coding: only for its jumps
    preset.see(k3::isOperation(in) ? std::optional(shown) : std::nullopt, now);
}

Result<void> K3Encoder::check(const Job &job) const
{
    if (auto checked = plan.check(job); !checked)
        return checked;
    return checkMode(job);
}

Result<void> K3Encoder::checkMode(const Job &job) const
{
    if (!device.mayHaveModes())
        return {};
    const auto mode = knowledge.mode();
    const auto word = wordOfTwoMeanings(job);
    const ParameterValues values = valuesOf(job);
    if (!word && mode == Mode::cam && !values.empty())
        return refuse(RefusalKind::notSupported, RefusalId::inCamMode,
                      {plan.parameterWord(values.front().parameter, values.front().value.number())});
    if (!word)
        return {};
    if (!mode)
        return refuse(RefusalKind::notSupported, RefusalId::modeNotKnown, {*word});
    if (*mode == Mode::cam && !std::holds_alternative<SwitchMode>(job)) // which leaves it first
        return refuse(RefusalKind::notSupported, RefusalId::inCamMode, {*word});
    return {};
}

Result<void> K3Encoder::checkState(const Job &job, Word in) const
{
    const bool isOutsideCamMode = isAboutCams(job) && knowledge.mode() != Mode::cam;
    if (!isStartedInOperation(job) && !isOutsideCamMode)
        return {};
    if (initialisesPreset(job) && in == k3::error)
        return tl::unexpected(noValidPosition());
    const EncoderState state = stateOf(in);
    if (state == EncoderState::parameterization)
        return refuse(RefusalKind::busy, RefusalId::inParameterization, {in});
    if (state == EncoderState::unknown)
        return refuse(RefusalKind::device, WordRefusalId::unknownState, {in});
    return {};
}

Refusal noValidPosition()
{
    return {RefusalKind::device, RefusalId::noValidPosition, {k3::error}};
}

} // namespace codewheel
