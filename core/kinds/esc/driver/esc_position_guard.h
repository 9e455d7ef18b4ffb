// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cstdint>
#include <optional>

namespace codewheel {

// Tells a position that can be true from one that cannot. The protocol has no checksum: a corrupted digit
// looks valid. A position further from the previous one than the encoder can turn in between is suspect until
// the next answer confirms or refutes it. Used by the driver of encoders on a serial line.
class EscPositionGuard
{
public:
    enum class Verdict : std::uint8_t { taken, suspect };

    struct Figures
    {
        int suspect = 0;   // each was asked for again
        int confirmed = 0; // of them: the encoder had really moved
        int refuted = 0;   // of them: the next answer fits the previous position

        friend bool operator==(const Figures &, const Figures &) = default;
    };

    struct Scale
    {
        double topSpeed = 6000; // revolutions per minute
        std::int64_t stepsPerTurn = 8192;
        std::optional<std::int64_t> total{}; // the position after total - 1 is 0

        friend bool operator==(const Scale &, const Scale &) = default;
    };

    void setScale(const Scale &scale) { m_scale = scale; }
    Verdict judge(std::int64_t position, Instant at);
    // The position may be anything now: after a preset, another scaling, another direction.
    void forget();

    // Whether the encoder can have turned from one to the other in this time.
    bool canReach(std::int64_t from, std::int64_t to, Instant within) const;
    // The shorter way from one to the other, in steps.
    std::int64_t turned(std::int64_t from, std::int64_t to) const;
    const Figures &figures() const { return m_figures; }

private:
    struct Sample
    {
        std::int64_t position = 0;
        Instant at{};
    };
    bool fits(const std::optional<Sample> &before, const Sample &now) const;

    Scale m_scale;
    std::optional<Sample> m_taken;
    std::optional<Sample> m_suspect;
    Figures m_figures;
};

} // namespace codewheel
