// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/take_over.h"

#include "kinds/interbus/ring/numbering.h"

#include <algorithm>

namespace codewheel {
namespace {

// A device of the result, and its connected counterpart, which determines where others are inserted.
struct Slot
{
    TakenDevice device;
    std::optional<std::size_t> beside;
};

// The configured devices without those that are removed or move.
std::vector<Slot> remainingSlots(const Comparison &comparison, const std::vector<bool> &isTaken)
{
    std::vector<Slot> slots;
    for (std::size_t n = 0; n < comparison.size(); ++n) {
        const ComparisonLine &line = comparison[n];
        const bool stays = line.kind == ComparisonKind::same || line.kind == ComparisonKind::differs;
        if (!line.configured || (!stays && isTaken[n]))
            continue;
        slots.push_back({{line.configured, isTaken[n] ? line.connected : std::nullopt},
                         stays ? line.connected : std::nullopt});
    }
    return slots;
}

// After the nearest of the devices that come before it in the connected ring.
void insertSlot(std::vector<Slot> &slots, TakenDevice device)
{
    const auto before = std::find_if(slots.rbegin(), slots.rend(), [&](const Slot &slot) {
        return slot.beside && *slot.beside < *device.other;
    });
    slots.insert(before.base(), {device, device.other});
}

} // namespace

std::vector<TakenDevice> takeOver(const Comparison &comparison, std::span<const std::size_t> lines)
{
    std::vector<bool> isTaken(comparison.size());
    for (const std::size_t line : lines)
        isTaken.at(line) = true;

    std::vector<Slot> slots = remainingSlots(comparison, isTaken);
    std::vector<TakenDevice> inserted;
    for (std::size_t n = 0; n < comparison.size(); ++n)
        if (isTaken[n] &&
            (comparison[n].kind == ComparisonKind::additional || comparison[n].kind == ComparisonKind::moved))
            inserted.push_back({comparison[n].configured, comparison[n].connected});
    std::ranges::sort(inserted, {}, &TakenDevice::other);
    for (const TakenDevice &device : inserted)
        insertSlot(slots, device);

    std::vector<TakenDevice> devices;
    std::ranges::transform(slots, std::back_inserter(devices), &Slot::device);
    return devices;
}

Comparison mirrored(Comparison comparison)
{
    for (ComparisonLine &line : comparison) {
        std::swap(line.configured, line.connected);
        if (line.kind == ComparisonKind::missing)
            line.kind = ComparisonKind::additional;
        else if (line.kind == ComparisonKind::additional)
            line.kind = ComparisonKind::missing;
    }
    return comparison;
}

RingDevice takenParticipant(const TakenDevice &device, const RingStructure &own, const RingStructure &other)
{
    if (!device.own)
        return other.at(*device.other);
    RingDevice participant = own.at(*device.own);
    if (device.other) {
        const RingDevice &found = other.at(*device.other);
        const bool keepsMake = isSameKind(participant, found) && !participant.deviceKey.isEmpty();
        const QString make = keepsMake ? participant.deviceKey : found.deviceKey;
        participant = found;
        participant.deviceKey = make;
    }
    return participant;
}

RingStructure takenOver(const RingStructure &own, const RingStructure &other, const Comparison &comparison,
                        std::span<const std::size_t> lines)
{
    RingStructure result;
    for (const TakenDevice &device : takeOver(comparison, lines))
        result.push_back(takenParticipant(device, own, other));
    numberDevices(result);
    return result;
}

} // namespace codewheel
