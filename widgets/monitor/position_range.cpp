// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/position_range.h"

#include "catalog/protocol_rules.h"
#include "catalog/total_range.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "vocabulary/circle.h"

namespace codewheel {
namespace {

PositionRange rangeOf(std::int64_t total, PositionCoding coding)
{
    if (coding != PositionCoding::signedBinary)
        return {0, total - 1};
    const std::int64_t firstNegative = (total + 1) / 2; // as an unsigned position
    return {signedPosition(firstNegative, total), firstNegative - 1};
}

} // namespace

std::optional<PositionRange> positionRange(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    if (device.find(Parameter::measuringLength) != nullptr) {
        const auto length = knownNumber(encoder, Parameter::measuringLength);
        return length ? std::optional(PositionRange{0, *length}) : std::nullopt;
    }
    if (onlyTellsPosition(device)) {
        const std::int64_t positions = physicalRange(device);
        return positions < 2 ? std::nullopt : std::optional(rangeOf(positions, device.coding));
    }
    const auto total = totalRange(device, valuesOf(allKnown(encoder)));
    const auto coding = device.hasWords() ? encoder.latest().coding : PositionCoding::binary;
    if (!total || *total < 2 || !coding)
        return {};
    return rangeOf(*total, *coding);
}

} // namespace codewheel
