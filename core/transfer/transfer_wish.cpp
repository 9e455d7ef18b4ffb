// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/transfer_wish.h"

#include "catalog/catalog.h"
#include "catalog/protocol_rules.h"
#include "jobs/values_to_write.h"
#include "project/project.h"
#include "transfer/project_places.h"

namespace codewheel {

namespace {

// The same kind of encoder on a remote bus and on Loop 2 has the same parameters, but another device code.
bool takeTheSame(const DeviceDescription &a, const DeviceDescription &b)
{
    return a.vendor == b.vendor && a.profile == b.profile && a.dialect == b.dialect &&
           a.parameters == b.parameters;
}

bool isOfItsPlace(Parameter parameter)
{
    return parameter == Parameter::lineAddress || parameter == Parameter::baudRate;
}

} // namespace

ParameterValues withoutItsPlace(ParameterValues values)
{
    std::erase_if(values, [](const ParameterValue &value) { return isOfItsPlace(value.parameter); });
    return values;
}

ParameterValues wantedSettings(const ProjectDevice &device, const DeviceDescription *description)
{
    ParameterValues values = withoutItsPlace(device.wanted);
    std::erase_if(values, [description](const ParameterValue &value) {
        const ParameterDescription *its = description ? description->find(value.parameter) : nullptr;
        return its != nullptr && isCommand(*description, *its);
    });
    return values;
}

bool isSetting(const DeviceDescription *device, const ParameterValue &value)
{
    const Parameter parameter = value.parameter;
    if (isOfItsPlace(parameter))
        return false;
    const ParameterDescription *its = device ? device->find(parameter) : nullptr;
    if (its == nullptr)
        return parameter < Parameter::lineAddress && parameter != Parameter::rodLength;
    return its->canBeWritten && !isCommand(*device, *its) && its->takes(value.value);
}

ParameterValues storedSettings(const ProjectDevice &device, const DeviceDescription *description)
{
    ParameterValues values;
    for (const StoredValue &stored : device.stored)
        if (const ParameterValue value{stored.parameter, stored.value}; isSetting(description, value))
            values.push_back(value);
    return values;
}

TransferWish wishOf(const ProjectDevice &device, TransferSource source, const ProjectPlaces &places,
                    const Catalog &catalog)
{
    TransferWish wish{.place = device.place(),
                      .station = device.station,
                      .deviceCode = device.participant.deviceCode,
                      .deviceKey = device.participant.deviceKey,
                      .hindrance = places.hindrance(device.place())};
    const auto planned = plannedDescription(device, catalog);
    const DeviceDescription *description = planned ? &*planned : nullptr;
    if (source == TransferSource::wanted) {
        wish.values = wantedSettings(device, description);
        wish.cams = device.wantedCams;
        return wish;
    }
    wish.values = storedSettings(device, description);
    for (const StoredCams &stored : device.storedCams)
        wish.cams.push_back(stored.program);
    return wish;
}

TransferWish wishToClone(const EncoderSession &from, const EncoderSession &to, bool withCams)
{
    TransferWish wish{.place = to.place()};
    if (!takeTheSame(from.device(), to.device()))
        wish.hindrance = Refusal{
            RefusalKind::badInput,
            RefusalId::encodersDiffer,
            {from.place().shown(), from.device().fullName(), to.place().shown(), to.device().fullName()}};
    for (const Known &known : allKnown(from))
        if (const ParameterValue value{known.parameter, known.value};
            isSetting(&to.device(), value) && value.parameter != Parameter::zeroOffset)
            wish.values.push_back(value);
    const auto &cams = to.can().cams;
    for (unsigned program = 1; withCams && cams && program <= cams->programs; ++program)
        if (const auto known = from.cams(program))
            wish.cams.push_back(known->program);
    return wish;
}

} // namespace codewheel
