// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/value_store.h"

#include "cams/check_cams.h"
#include "catalog/device_description.h"
#include "jobs/values_to_write.h"
#include "transfer/last_positions.h"

#include <algorithm>

namespace codewheel {
namespace {

SwitchMode modeOf(const Reading &reading)
{
    return reading.mode ? SwitchMode{*reading.mode, reading.camProgram.value_or(0)} : SwitchMode{};
}

// Those of `now`, plus those of `before` that have no counterpart there; in the order of the key.
template <typename Stored, typename Key>
std::vector<Stored> mergedStore(std::vector<Stored> now, const std::vector<Stored> &before, Key key)
{
    const std::size_t known = now.size();
    for (const Stored &one : before)
        if (std::none_of(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(known),
                         [&](const Stored &other) { return key(other) == key(one); }))
            now.push_back(one);
    std::ranges::stable_sort(now, {}, key);
    return now;
}

} // namespace

EncoderJobs jobsToStore(const EncoderSession &encoder, bool withCams)
{
    EncoderJobs jobs{.place = encoder.place(), .jobs = {}};
    if (encoder.can().reads) {
        ReadParameters read{encoder.device().readableValues()};
        std::erase(read.parameters, Parameter::temperature); // not every encoder has one
        jobs.jobs.emplace_back(std::move(read));
    }
    if (const auto &cams = encoder.can().cams; withCams && cams)
        jobs.jobs.emplace_back(
            ReadCams{.programs = programNumbers(*cams), .afterwards = modeOf(encoder.latest())});
    return jobs;
}

std::vector<StoredValue> valuesToStore(const EncoderSession &encoder)
{
    std::vector<StoredValue> values;
    for (const Known &known : allKnown(encoder))
        if (known.parameter != Parameter::temperature)
            values.push_back(
                {known.parameter, known.value, known.evidence, encoder.dateTime(known.at).toUTC()});
    return values;
}

std::vector<StoredCams> camsToStore(const EncoderSession &encoder)
{
    std::vector<StoredCams> cams;
    for (unsigned program = 1; program <= CamProgram::programs; ++program)
        if (const auto known = encoder.cams(program))
            cams.push_back({known->program, known->evidence, encoder.dateTime(known->at).toUTC()});
    return cams;
}

ProjectDevice withStored(ProjectDevice device, const EncoderSession &encoder)
{
    device.stored = mergedStore(valuesToStore(encoder), device.stored,
                                [](const StoredValue &value) { return value.parameter; });
    device.storedCams = mergedStore(camsToStore(encoder), device.storedCams,
                                    [](const StoredCams &cams) { return cams.program.number; });
    if (const auto position = positionToKeep(encoder))
        device.lastPosition = position;
    return device;
}

Message valuesStoredMessage(const std::vector<ProjectDevice> &devices)
{
    std::int64_t values = 0;
    for (const ProjectDevice &device : devices)
        values += std::ssize(device.stored);
    return {.id = MessageId::valuesStored, .arguments = {std::ssize(devices), values}};
}

} // namespace codewheel
