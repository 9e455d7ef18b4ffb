// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/replacement.h"

#include "catalog/device_description.h"
#include "jobs/values_to_write.h"
#include "transfer/project_places.h"

#include <algorithm>

namespace codewheel {
namespace {

// Parameter 3 of FRABA and Baumer: the same numbers if the coding is unsigned (FRABA manual 10.1, Baumer
// manual 4).
ParameterValue forDevice(const DeviceDescription &device, const ParameterValue &value)
{
    const bool isDirection = value.parameter == Parameter::direction;
    const bool isCoding = value.parameter == Parameter::coding;
    if (device.find(value.parameter) != nullptr || (!isDirection && !isCoding))
        return value;
    const Parameter other = isDirection ? Parameter::coding : Parameter::direction;
    const ParameterDescription *description = device.find(other);
    const bool hasIt = description != nullptr && description->findChoice(value.value) != nullptr;
    return hasIt ? ParameterValue{other, value.value} : value;
}

ParameterValues forDevice(const DeviceDescription &device, const ParameterValues &values)
{
    ParameterValues all;
    for (const ParameterValue &value : values)
        all.push_back(forDevice(device, value));
    return all;
}

ParameterValues valuesFor(const ProjectDevice &planned, const DeviceDescription &device)
{
    return forDevice(device, settingsOfNew(planned, &device));
}

std::vector<CamProgram> camsFor(const ProjectDevice &planned)
{
    std::vector<CamProgram> cams = planned.wantedCams;
    for (const StoredCams &stored : planned.storedCams)
        if (std::ranges::find(cams, stored.program.number, &CamProgram::number) == cams.end())
            cams.push_back(stored.program);
    return cams;
}

ParameterValues valuesToWrite(const ProjectDevice &planned, const DeviceDescription &device)
{
    ParameterValues values = valuesFor(planned, device);
    std::erase_if(values, [&](const ParameterValue &value) {
        const ParameterDescription *parameter = device.find(value.parameter);
        return parameter == nullptr || !parameter->canBeWritten;
    });
    return values;
}

std::optional<std::pair<int, int>> difference(int before, int now)
{
    const bool differs = before != 0 && now != 0 && before != now;
    return differs ? std::optional(std::pair(before, now)) : std::nullopt;
}

int told(int ofLabel, int ofDescription)
{
    return ofLabel != 0 ? ofLabel : ofDescription;
}

} // namespace

ReplacementDifferences differencesOf(const ProjectDevice &planned, const DeviceDescription *before,
                                     const Replacement &now)
{
    ReplacementDifferences differences;
    const DeviceDescription &device = *now.device;
    if (before != nullptr && before->key != device.key)
        differences.makeBefore = before->fullName();
    differences.stepsPerTurn =
        difference(told(planned.label.stepsPerTurn, before ? before->physicalStepsPerTurn : 0),
                   told(now.stepsPerTurn, device.physicalStepsPerTurn));
    differences.turns = difference(told(planned.label.turns, before ? before->physicalTurns : 0),
                                   told(now.turns, device.physicalTurns));
    for (const ParameterValue &value : valuesFor(planned, device))
        if (device.find(value.parameter) == nullptr)
            differences.notTaken.push_back(value);
    differences.camsNotTaken = !device.capabilities.cams && !camsFor(planned).empty();
    return differences;
}

ParameterValues settingsOfNew(const ProjectDevice &planned, const DeviceDescription *device)
{
    ParameterValues values = storedSettings(planned, device);
    for (const ParameterValue &wanted : wantedSettings(planned, device))
        replaceValue(values, wanted);
    return values;
}

TransferWish wishToReplace(const ProjectDevice &planned, const Replacement &now,
                           std::optional<std::int64_t> position, const ProjectPlaces &places)
{
    TransferWish wish{.place = planned.place(),
                      .station = planned.station,
                      .deviceCode = now.device->deviceCode,
                      .deviceKey = now.device->key,
                      .serialNumber = now.serialNumber,
                      .values = valuesToWrite(planned, *now.device),
                      .position = position,
                      .toPositionMode = true,
                      .newEncoder = now.device->labelled(now.turns, now.stepsPerTurn),
                      .hindrance = places.hindranceToReplace(planned.place())};
    if (now.device->capabilities.cams)
        wish.cams = camsFor(planned);
    return wish;
}

ProjectDevice replaced(ProjectDevice planned, const Replacement &now, std::optional<std::int64_t> position)
{
    const ParameterValues toWrite = valuesToWrite(planned, *now.device);
    if (now.device->capabilities.cams)
        planned.wantedCams = camsFor(planned);
    std::ranges::sort(planned.wantedCams, {}, &CamProgram::number);
    planned.participant.deviceKey = now.device->key;
    planned.label = {now.turns, now.stepsPerTurn, now.serialNumber};
    planned.wanted = forDevice(*now.device, planned.wanted);
    for (const ParameterValue &value : toWrite)
        replaceValue(planned.wanted, value);
    const WriteWish wish{.wanted = planned.wanted, .setPositionTo = position};
    if (const auto leftOut = offsetLeftOut(*now.device, wish)) // written later, it would move the position
        std::erase(planned.wanted, *leftOut);
    std::ranges::sort(planned.wanted, {}, &ParameterValue::parameter);
    planned.stored.clear();
    planned.storedCams.clear();
    return planned;
}

Message encoderReplacedMessage(const ProjectDevice &before, const Replacement &now)
{
    const auto shown = [](const QString &number) {
        return number.isEmpty() ? QStringLiteral("\u2013") : number;
    };
    return {.place = before.place(),
            .id = MessageId::encoderReplaced,
            .arguments = {shown(before.label.serialNumber), shown(now.serialNumber)}};
}

} // namespace codewheel
