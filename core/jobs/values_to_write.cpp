// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/values_to_write.h"

#include "catalog/device_description.h"
#include "catalog/kept_values.h"
#include "catalog/protocol_rules.h"
#include "jobs/protocol.h"
#include "jobs/shown_error.h"

#include <algorithm>

namespace codewheel {
namespace {

bool mustBeRearmed(const EncoderSession &encoder, const WriteWish &wish)
{
    if (!wish.initialisePreset || !encoder.device().quirks.presetNeedsRearming)
        return false;
    const auto flag = encoder.known(Parameter::presetFlag);
    return !flag || flag->value == 0;
}

bool canBeGiven(const DeviceDescription &device, Parameter parameter)
{
    const ParameterDescription *its = device.find(parameter);
    return its != nullptr && its->canBeWritten;
}

// Setting the position programs the preset itself. Only an encoder that has lost its parameters needs it
// before, to work at all.
ParameterValues valuesFirst(const EncoderSession &encoder, const WriteWish &wish)
{
    WriteWish first = wish;
    if (wish.setPositionTo) {
        std::erase_if(first.wanted,
                      [](const ParameterValue &value) { return value.parameter == Parameter::preset; });
        if (hasLostParameters(encoder) && canBeGiven(encoder.device(), Parameter::preset))
            first.wanted.push_back({Parameter::preset, *wish.setPositionTo});
    }
    return inTurn(encoder.device(), first);
}

// What can be restored: known, and writable.
ParameterValues valuesBefore(const EncoderSession &encoder)
{
    ParameterValues values;
    for (const Known &known : allKnown(encoder))
        if (const ParameterDescription *description = encoder.device().find(known.parameter);
            description != nullptr && description->canBeWritten)
            values.push_back({known.parameter, known.value});
    return values;
}

bool isRead(const EncoderSession &encoder, Parameter parameter)
{
    const auto known = encoder.known(parameter);
    return known && known->evidence == Evidence::read;
}

// Empty: it may be another value.
std::optional<Known> knownToBe(const EncoderSession &encoder, const ParameterValue &value)
{
    const auto known = encoder.known(value.parameter);
    const bool isSure = known && (known->evidence != Evidence::told || !encoder.can().reads);
    return isSure && known->value == value.value ? known : std::nullopt;
}

std::optional<RefusalCode> errorOf(const EncoderSession &encoder)
{
    const Reading &reading = encoder.latest();
    return reading.state == EncoderState::error ? std::optional(shownError(encoder.device(), reading).id)
                                                : std::nullopt;
}

std::vector<KnownCams> allKnownCams(const EncoderSession &encoder)
{
    std::vector<KnownCams> all;
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        if (const auto known = encoder.cams(number))
            all.push_back(*known);
    return all;
}

} // namespace

std::optional<ParameterValue> offsetLeftOut(const DeviceDescription &device, const WriteWish &wish)
{
    const auto offset = protocolOf(device).presetOffset();
    const bool isReplaced = wish.initialisePreset || wish.setPositionTo;
    if (!isReplaced || !offset || !canBeGiven(device, *offset))
        return std::nullopt;
    const auto value = valueOf(wish.wanted, *offset);
    return value ? std::optional(ParameterValue{*offset, *value}) : std::nullopt;
}

ParameterValues inTurn(const DeviceDescription &device, const WriteWish &wish)
{
    ParameterValues values = wish.wanted;
    if (const auto leftOut = offsetLeftOut(device, wish))
        std::erase(values, *leftOut);
    if (!wish.inOrderGiven)
        std::ranges::stable_sort(values, {}, [&](const ParameterValue &value) {
            return std::ranges::find(device.parameters, value.parameter, &ParameterDescription::parameter) -
                   device.parameters.begin();
        });
    return values;
}

bool hasLostParameters(const EncoderSession &encoder)
{
    return errorOf(encoder) == RefusalId::parametersLost;
}

bool holdsOtherValues(const EncoderSession &encoder)
{
    return hasLostParameters(encoder) || errorOf(encoder) == RefusalId::wrongParameterData;
}

std::vector<Parameter> lostAndNotAmong(const EncoderSession &encoder, const ParameterValues &values)
{
    std::vector<Parameter> lost;
    if (!hasLostParameters(encoder))
        return lost;
    for (const ParameterDescription &its : encoder.device().parameters)
        if (its.isNeededAfterLoss && !findValue(values, its.parameter))
            lost.push_back(its.parameter);
    return lost;
}

bool isThereAlready(const EncoderSession &encoder, const ParameterValue &value)
{
    const auto known = knownToBe(encoder, value);
    return known && !hasToBeStored(encoder.device(), *known);
}

bool isOnlyToBeStored(const EncoderSession &encoder, const ParameterValue &value)
{
    const auto known = knownToBe(encoder, value);
    return known && hasToBeStored(encoder.device(), *known);
}

WriteParameters jobForWish(const EncoderSession &encoder, const WriteWish &wish)
{
    WriteParameters job{
        .values = {}, .previous = valuesBefore(encoder), .initialisePreset = wish.initialisePreset};
    const bool writesAll = wish.writeAll || holdsOtherValues(encoder);
    for (const ParameterValue &wanted : valuesFirst(encoder, wish)) {
        const ParameterDescription *description = encoder.device().find(wanted.parameter);
        if (description == nullptr)
            continue;
        const bool rearms = wanted.parameter == Parameter::preset && mustBeRearmed(encoder, wish);
        if (!writesAll && !rearms && isThereAlready(encoder, wanted))
            continue;
        job.values.push_back(wanted);
        const bool readFirst = !isRead(encoder, wanted.parameter) || isOnlyToBeStored(encoder, wanted) ||
                               (rearms && !isRead(encoder, Parameter::presetFlag));
        const bool canBeRead = description->canBeRead;
        if (!writesAll && encoder.can().reads && canBeRead && readFirst)
            job.onlyWhatDiffers = true;
    }
    const ParameterValues written = job.values;
    for (const ParameterValue &wanted : wish.wanted)
        if (!findValue(written, wanted.parameter) &&
            protocolOf(encoder.device()).goesAlong(wanted.parameter, written))
            job.values.push_back(wanted);
    return job;
}

std::vector<Job> jobsForWish(const EncoderSession &encoder, const WriteWish &wish)
{
    std::vector<Job> jobs;
    WriteParameters write = jobForWish(encoder, wish);
    const bool programsItsOwn = mustBeRearmed(encoder, wish) && !valueOf(write.values, Parameter::preset);
    write.initialisePreset = write.initialisePreset && !programsItsOwn;
    if (!write.values.empty() || !(programsItsOwn || wish.setPositionTo))
        jobs.emplace_back(write);
    if (programsItsOwn)
        jobs.emplace_back(SetPreset{});
    if (wish.setPositionTo)
        jobs.emplace_back(SetPreset{.value = wish.setPositionTo});
    const auto preset = wish.setPositionTo ? valueOf(wish.wanted, Parameter::preset) : std::nullopt;
    if (preset && preset != wish.setPositionTo)
        jobs.emplace_back(WriteParameters{
            .values = {{Parameter::preset, *preset}}, .onlyWhatDiffers = true, .previous = {}});
    return jobs;
}

namespace {

// What comes behind a new address is sent to that.
void moveTo(PlanBasis &basis, const Job &job)
{
    const auto *write = std::get_if<WriteParameters>(&job);
    const auto address = write ? valueOf(write->values, Parameter::lineAddress) : std::nullopt;
    if (!address)
        return;
    std::erase_if(basis.known, [](const Known &known) { return known.parameter == Parameter::lineAddress; });
    basis.known.push_back({Parameter::lineAddress, *address, Evidence::told, {}});
}

} // namespace

// Each job leaves 00000000 in OUT.
Result<std::vector<Step>> stepsForJobs(const EncoderSession &encoder, const std::vector<Job> &jobs, Word out)
{
    std::vector<Step> all;
    PlanBasis basis{allKnown(encoder),      allKnownCams(encoder), out,
                    encoder.valueOptions(), encoder.place().node,  encoder.latest()};
    for (const Job &job : jobs) {
        auto steps = plannedSteps(encoder.device(), job, basis);
        if (!steps)
            return steps;
        basis.out = 0;
        moveTo(basis, job);
        all.insert(all.end(), steps->begin(), steps->end());
    }
    return all;
}

std::vector<Known> allKnown(const EncoderSession &encoder)
{
    std::vector<Known> all;
    for (const Parameter parameter : allParameters())
        if (const auto known = encoder.known(parameter))
            all.push_back(*known);
    return all;
}

bool takesValue(const Step &step)
{
    return step.effect == Effect::takes;
}

bool writesValue(const Step &step)
{
    return !step.parameters.empty() && takesValue(step);
}

bool readsCams(const Step &step)
{
    return step.effect == Effect::readsCams || step.effect == Effect::reads;
}

int storingSteps(std::span<const Step> steps, const DeviceDescription &device)
{
    const Effect storing = protocolRules(device.profile).storesByStep() ? Effect::stores : Effect::takes;
    return static_cast<int>(std::ranges::count(steps, storing, &Step::effect));
}

int eepromWritesOf(const std::vector<Step> &steps, const DeviceDescription &device)
{
    const auto presets =
        mayStorePreset(device) ? std::ranges::count(steps, Effect::setsPosition, &Step::effect) : 0;
    return storingSteps(steps, device) + static_cast<int>(presets);
}

} // namespace codewheel
