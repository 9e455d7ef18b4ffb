// SPDX-License-Identifier: GPL-3.0-or-later
// A plan beside what is connected, where each device has a place of its own.
#include "bus/encoder_bus.h"
#include "project/plan_rules.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {

namespace {

void addDevice(ConnectedBus &connected, const EncoderBus &bus, const Participant &device)
{
    connected.devices.push_back(device);
    if (auto old = notLive(bus, bus.placeOf(device.number)))
        connected.notLive.emplace(device.number, std::move(*old));
}

} // namespace

// An encoder that does not answer is not connected.
ConnectedBus connectedBus(const Project &project, const EncoderBus &bus)
{
    ConnectedBus connected;
    for (const Place place : bus.places()) {
        const EncoderSession *encoder = bus.encoder(place);
        const auto found = bus.found(place);
        if (found && !(encoder && encoder->latest().state == EncoderState::silent))
            addDevice(connected, bus, *found);
    }
    for (const ProjectDevice &device : devicesOn(project, bus.id()))
        if (auto why = bus.isOther(device.place(), device.participant.deviceKey, device.label.serialNumber))
            connected.others.emplace(device.place().node, std::move(*why));
    return connected;
}

Comparison PlanRules::compare(const Project &project, BusId bus, const ConnectedBus &connected) const
{
    const Devices planned = devicesOn(project, bus);
    Comparison lines;
    for (std::size_t i = 0; i < planned.size(); ++i) {
        const NodeId node = planned[i].place().node;
        const auto there = std::ranges::find(connected.devices, node, &Participant::number);
        ComparisonLine &line = lines.emplace_back(ComparisonLine{ComparisonKind::missing, i, {}});
        if (there == connected.devices.end())
            continue;
        line.kind = connected.others.contains(node) ? ComparisonKind::differs : ComparisonKind::same;
        line.connected = static_cast<std::size_t>(there - connected.devices.begin());
    }
    for (std::size_t i = 0; i < connected.devices.size(); ++i)
        if (findDevice(project, {bus, connected.devices[i].number}) == nullptr)
            lines.push_back({ComparisonKind::additional, {}, i});
    std::ranges::stable_sort(lines, {}, [&](const ComparisonLine &line) {
        return line.configured ? planned[*line.configured].place().node
                               : connected.devices[*line.connected].number;
    });
    return lines;
}

QString PlanRules::comparisonText(const ComparisonLine &line, const Project &project, BusId bus,
                                  const ConnectedBus &connected, const Catalog &catalog) const
{
    const Participant &device = line.configured ? devicesOn(project, bus)[*line.configured].participant
                                                : connected.devices[*line.connected];
    const QStringList placeAndName{device.number.toString(), nameOf(device, catalog)};
    switch (line.kind) {
    case ComparisonKind::additional:
        return sentence(tr("%1: %2 is additional: it is not configured"), placeAndName);
    case ComparisonKind::missing:
        return sentence(tr("%1: configured %2 is missing"), placeAndName);
    case ComparisonKind::differs:
        return refusalText(connected.others.at(device.number));
    case ComparisonKind::moved:
    case ComparisonKind::same:
        break;
    }
    return sentence(tr("%1: %2, as configured"), placeAndName);
}

EditedPlan PlanRules::takenOver(const Project &project, BusId bus, const ConnectedBus &connected,
                                const Comparison &comparison, std::span<const std::size_t> lines) const
{
    const Devices planned = devicesOn(project, bus);
    EditedPlan after;
    for (std::size_t n = 0; n < comparison.size(); ++n) {
        const ComparisonLine &line = comparison[n];
        const bool isTaken = std::ranges::find(lines, n) != lines.end();
        if (isTaken ? !line.connected : !line.configured)
            continue;
        ProjectDevice &device = after.devices.emplace_back();
        after.from.push_back(line.configured);
        if (line.configured)
            device = planned[*line.configured];
        if (isTaken && line.kind == ComparisonKind::differs)
            becomeAnother(device);
        if (isTaken && line.kind != ComparisonKind::same)
            device.participant = connected.devices[*line.connected];
        device.bus = bus;
    }
    return after;
}

} // namespace codewheel
