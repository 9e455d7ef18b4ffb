// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/wanted_scale.h"

#include "jobs/preset_position.h"
#include "jobs/protocol.h"
#include "jobs/value_notes.h"

namespace codewheel {

std::optional<PositionScale> scaleNow(const Setup &setup)
{
    return scaleOf(setup.encoder->device(), [&](Parameter parameter) { return setup.valueNow(parameter); });
}

std::optional<PositionScale> scaleAfter(const Setup &setup)
{
    if (!setup.encoder)
        return std::nullopt;
    return scaleAfter(setup.encoder->device(), setup.wish.wanted, valuesOf(allKnown(*setup.encoder)));
}

std::optional<std::int64_t> valueThenOf(const Setup &setup, Parameter parameter)
{
    if (!setup.encoder)
        return std::nullopt;
    return protocolOf(setup.encoder->device())
        .valueAfter(parameter, setup.wish.wanted, valuesOf(allKnown(*setup.encoder)));
}

std::optional<ForetoldPosition> positionAfterHandshake(const Setup &setup)
{
    const auto then = scaleAfter(setup);
    if (!then)
        return std::nullopt;
    if (setup.wish.setPositionTo)
        return ForetoldPosition{*setup.wish.setPositionTo, true};
    if (setup.wish.initialisePreset) {
        const auto preset = presetPosition(
            setup.encoder->device(), [&](Parameter its) { return setup.valueAfter(its); },
            setup.encoder->latest().coding);
        return preset ? std::optional(ForetoldPosition{preset->position, true}) : std::nullopt;
    }
    const auto now = scaleNow(setup);
    const auto position = setup.encoder->latest().position;
    if (setup.encoder->freshness().isOld()) // it may have moved since
        return std::nullopt;
    return now && position ? foretellPosition(*now, *position, *then) : std::nullopt;
}

std::optional<ForetoldPosition> positionWithTaken(const Setup &setup)
{
    const HandshakeRecord &record = setup.record;
    if (!record.positionBefore)
        return std::nullopt;
    const ParameterValues values = valuesOf(record.before);
    const auto before = [&](Parameter parameter) { return valueOf(values, parameter); };
    const ParameterValues taken = record.taken();
    const auto now = scaleOf(setup.encoder->device(), before);
    const auto then = scaleOf(setup.encoder->device(), [&](Parameter parameter) {
        const auto value = valueOf(taken, parameter);
        return value ? value : before(parameter);
    });
    return now && then ? foretellPosition(*now, *record.positionBefore, *then) : std::nullopt;
}

} // namespace codewheel
