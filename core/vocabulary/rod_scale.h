// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

namespace codewheel {

// Rod lengths are stored in micrometres and shown in millimetres.
double millimetresOf(std::int64_t micrometres);
std::int64_t micrometresOf(double millimetres);

// Converts the position of a rod into millimetres: its measuring length in steps and as on its label (LA-66
// manual 3.2: steps = length [mm] / resolution [mm]).
struct RodScale
{
    std::int64_t steps = 1;       // 1..FFFFFFh
    std::int64_t micrometres = 0; // of the same length

    double millimetres(std::int64_t position) const;
    // "123.45 mm", by locale; as many decimals as it takes to tell one step from the next, 3 at most.
    QString text(std::int64_t position) const;

    friend constexpr bool operator==(const RodScale &, const RodScale &) = default;
};

// Empty if the measuring length or the length of the rod is not known.
std::optional<RodScale> rodScale(std::optional<std::int64_t> measuringLength,
                                 std::optional<std::int64_t> rodLength);
std::optional<RodScale> rodScale(const EncoderSession &encoder);

} // namespace codewheel
