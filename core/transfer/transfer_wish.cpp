// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/transfer_wish.h"

#include "catalog/device_description.h"
#include "drivers/values_to_write.h"
#include "transfer/project_places.h"

namespace codewheel {

namespace {

// One kind of encoder on a remote bus and on Loop 2 has the same parameters, and another device code.
bool takeTheSame(const DeviceDescription &a, const DeviceDescription &b)
{
    return a.vendor == b.vendor && a.profile == b.profile && a.dialect == b.dialect &&
           a.parameters == b.parameters;
}

} // namespace

// What stands on a label and what an encoder tells of itself come behind all settings.
bool isSetting(Parameter parameter)
{
    return parameter < Parameter::rodLength;
}

ParameterValues storedSettings(const ProjectDevice &device)
{
    ParameterValues values;
    for (const StoredValue &stored : device.stored)
        if (isSetting(stored.parameter))
            values.push_back({stored.parameter, stored.value});
    return values;
}

TransferWish wishOf(const ProjectDevice &device, TransferSource source, const ProjectPlaces &places)
{
    TransferWish wish{.place = device.place(),
                      .station = device.station,
                      .deviceCode = device.participant.deviceCode,
                      .deviceKey = device.participant.deviceKey,
                      .hindrance = places.hindrance(device.place())};
    if (source == TransferSource::wanted) {
        wish.values = device.wanted;
        wish.cams = device.wantedCams;
        return wish;
    }
    wish.values = storedSettings(device);
    for (const StoredCams &stored : device.storedCams)
        wish.cams.push_back(stored.program);
    return wish;
}

TransferWish wishToClone(const EncoderSession &from, const EncoderSession &to, bool withCams)
{
    TransferWish wish{.place = to.place()};
    if (!takeTheSame(from.device(), to.device()))
        wish.hindrance = Refusal{RefusalKind::badInput,
                                 RefusalId::encodersDiffer,
                                 {from.place().toString(), from.device().fullName(), to.place().toString(),
                                  to.device().fullName()}};
    for (const Known &known : allKnown(from))
        if (isSetting(known.parameter) && known.parameter != Parameter::zeroOffset)
            wish.values.push_back({known.parameter, known.value});
    for (unsigned program = 1; withCams && program <= CamProgram::programs; ++program)
        if (const auto known = from.cams(program))
            wish.cams.push_back(known->program);
    return wish;
}

} // namespace codewheel
