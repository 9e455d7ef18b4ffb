// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"

#include <optional>

namespace codewheel {

class EncoderSession;

// What the encoder shows now, as far as it concerns the cams of one program.
struct CamLive
{
    // Where the shaft is: one position, or in cam mode the positions that give the same D24..D8.
    struct Position
    {
        std::int64_t first = 0;
        std::int64_t last = 0;

        friend bool operator==(const Position &, const Position &) = default;
    };

    std::array<std::optional<bool>, CamProgram::cams> on{}; // nothing: not known
    bool isTold = false; // by the encoder in cam mode; else worked out from the position
    std::optional<Position> position;
    bool isOld = false; // the position is an old one, and the present state of the cams is not known

    bool knowsAny() const; // any of `on`

    friend bool operator==(const CamLive &, const CamLive &) = default;
};

// For the cams of `shown` on an encoder with positions 0..largest.
CamLive camLive(const EncoderSession &encoder, const CamProgram &shown, std::int64_t largest);

} // namespace codewheel
