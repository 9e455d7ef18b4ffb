// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/reported_device.h"

#include "vocabulary/bus_names.h"
#include "vocabulary/find_by.h"
#include "vocabulary/known_words.h"

#include <algorithm>

namespace codewheel {
namespace {

// For a serial encoder only the name tells what it is.
const DeviceDescription *descriptionOf(const ProjectDevice &planned, const Catalog &catalog)
{
    const DeviceDescription *named = catalog.find(planned.participant.deviceKey);
    const unsigned deviceCode = planned.participant.deviceCode;
    return named && (named->deviceCode == deviceCode || !named->hasWords()) ? named
                                                                            : catalog.generic(deviceCode);
}

std::vector<NamedBus> busesWithDevices(const Project &project)
{
    std::vector<NamedBus> buses;
    for (const PlannedBus &bus : project.buses)
        if (!devicesOn(project, bus.id).empty())
            buses.push_back({bus.id, bus.kind, bus.name});
    return buses;
}

} // namespace

const StoredValue *ReportedDevice::known(Parameter parameter) const
{
    return findBy(values, parameter, &StoredValue::parameter);
}

QString ReportedDevice::evidence(Parameter parameter) const
{
    const StoredValue *value = known(parameter);
    if (value == nullptr)
        return {};
    const auto its = kept.find(parameter);
    return known_words::word(value->evidence, its == kept.end() ? Kept::byItself : its->second);
}

const StoredCams *ReportedDevice::knownCams(unsigned program) const
{
    return findBy(cams, program, [](const StoredCams &each) { return each.program.number; });
}

const CamProgram *ReportedDevice::wantedCams(unsigned program) const
{
    return findBy(planned->wantedCams, program, &CamProgram::number);
}

ParameterValues ReportedDevice::knownValues() const
{
    ParameterValues all;
    for (const StoredValue &value : values)
        all.push_back({value.parameter, value.value});
    return all;
}

std::vector<Parameter> ReportedDevice::parameters() const
{
    std::vector<Parameter> listed;
    for (const Parameter parameter : allParameters()) {
        if (parameter == Parameter::serialNumber)
            continue; // not a setting: it identifies the encoder
        const ParameterDescription *described = description ? description->find(parameter) : nullptr;
        const bool isSetting = described && (described->canBeWritten || described->onLabel);
        if (isSetting || known(parameter) || valueOf(planned->wanted, parameter))
            listed.push_back(parameter);
    }
    return listed;
}

std::vector<unsigned> ReportedDevice::camPrograms() const
{
    std::vector<unsigned> numbers;
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        if (wantedCams(number) || knownCams(number))
            numbers.push_back(number);
    return numbers;
}

std::vector<ReportedDevice> reportedDevices(const ReportInput &input, const Catalog &catalog)
{
    std::vector<ReportedDevice> devices;
    const auto names = namesOfSeveral(busesWithDevices(input.project));
    for (const ProjectDevice &planned : input.project.devices) {
        ReportedDevice device{.planned = &planned,
                              .shownPlace = codewheel::shownPlace(planned.place(), names),
                              .description = descriptionOf(planned, catalog),
                              .values = planned.stored,
                              .cams = planned.storedCams};
        if (const auto live = input.live.find(planned.place()); live != input.live.end()) {
            device.isConnected = true;
            device.notLive = live->second.notLive;
            device.isSimulated = live->second.isSimulated;
            device.values = live->second.values;
            device.kept = live->second.kept;
            device.cams = live->second.cams;
        }
        devices.push_back(std::move(device));
    }
    return devices;
}

} // namespace codewheel
