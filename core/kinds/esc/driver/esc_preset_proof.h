// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/driver/esc_position_agreement.h"

#include <QByteArray>

#include <optional>

namespace codewheel {

// What was read before and after a preset was sent, and whether that shows it was done: the protocol has no
// checksum, and a CR LF alone proves nothing. Part of EscJob.
struct EscPresetProof
{
    enum class Said : std::uint8_t { done, notDone, nothing };

    // A position that the reads agreed on.
    struct Position
    {
        EscPositionAgreement::Sample sample;
        double speed = 0; // steps per us
    };

    std::optional<Instant> sentAt;
    QByteArray line;                         // the command
    std::optional<std::int64_t> valueBefore; // S
    std::optional<std::int64_t> valueAfter;
    std::optional<Position> positionBefore;
    std::optional<Position> positionAfter;

    // `preset` in steps; the guard knows how far the shaft can turn.
    Said positionSays(std::int64_t preset, const EscPositionGuard &guard) const;
    Said valueSays(std::int64_t preset, bool isAnswered) const;
    // The position is where a shaft that was at the preset when it was sent has turned to.
    bool hasTurnedFromPreset(std::int64_t preset, const EscPositionGuard &guard) const;
};

} // namespace codewheel
