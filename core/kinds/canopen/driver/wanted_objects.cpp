// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/driver/wanted_objects.h"

#include "kinds/canopen/driver/node_plan.h"
#include "kinds/canopen/eds/device_file.h"
#include "kinds/canopen/protocol/canopen_reach.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

FileValue wholeValue(const Value &value)
{
    return value.isText() ? FileValue{value.toString()} : FileValue{value.number()};
}

// Bits of one object are wanted together.
void want(std::vector<WantedObject> &wanted, const CanopenReach &reach, const Value &value)
{
    if (!reach.bit) {
        wanted.push_back({.object = reach.object, .value = wholeValue(value)});
        return;
    }
    auto same = std::ranges::find(wanted, reach.object, &WantedObject::object);
    if (same == wanted.end())
        same = wanted.insert(same, {.object = reach.object, .value = {std::int64_t{0}}});
    const std::uint32_t bit = std::uint32_t{1} << *reach.bit;
    same->bits |= bit;
    if (value.number() != 0)
        same->value = {*same->value.number() | bit};
}

// The sign is nowhere on the wire: without a type nobody knows it.
bool isSameOnTheWire(std::int64_t one, std::int64_t other)
{
    constexpr std::int64_t leastOf32Bits = -0x8000'0000LL;
    constexpr std::int64_t mostOf32Bits = 0xFFFF'FFFFLL;
    const bool are32Bits = std::min(one, other) >= leastOf32Bits && std::max(one, other) <= mostOf32Bits;
    return one == other ||
           (are32Bits && static_cast<std::uint32_t>(one) == static_cast<std::uint32_t>(other));
}

} // namespace

bool WantedObject::isMetBy(const FileValue &now) const
{
    const std::int64_t *wanted = value.number();
    const std::int64_t *its = now.number();
    if (wanted == nullptr || its == nullptr)
        return value == now;
    return bits != 0 ? (static_cast<std::uint32_t>(*its) & bits) == static_cast<std::uint32_t>(*wanted)
                     : isSameOnTheWire(*wanted, *its);
}

std::vector<WantedObject> wantedObjects(const DeviceDescription &device, const ParameterValues &values,
                                        const std::vector<CamProgram> &cams)
{
    std::vector<WantedObject> wanted;
    for (const ParameterValue &value : values) {
        const ParameterDescription *its = device.find(value.parameter);
        if (const CanopenReach *reach = its != nullptr ? canopenReach(*its) : nullptr)
            want(wanted, *reach, value.value);
    }
    const NodePlan plan(device, {});
    for (const CamProgram &program : cams)
        for (const NodeStep &step : plan.cams(program, std::nullopt))
            if (step.task == NodeStep::Task::writeCam)
                wanted.push_back(
                    {.object = step.object, .value = {std::int64_t{static_cast<std::int32_t>(step.number)}}});
    std::ranges::sort(wanted, {}, [](const WantedObject &one) { return orderOf(one.object); });
    return wanted;
}

} // namespace codewheel::canopen
