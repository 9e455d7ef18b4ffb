// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/preset_position.h"
#include "kinds/interbus/k3/k3_knowledge.h"
#include "kinds/interbus/k3/k3_step.h"

namespace codewheel {

// Whether a preset (40000000h, 60000000h) was carried out, which no K3 encoder acknowledges: the position
// jumps to preset + offset, or was there before. It sees the positions before and behind the word, and takes
// from them how far the shaft may have turned between two of them. Part of K3Encoder, which lets it
// see all positions; K3Run asks it.
class K3PresetProof
{
public:
    enum class Said : std::uint8_t { nothing, done, notDone };

    using Target = PresetPosition;

    // A position, or IN shows none. Once per cycle.
    void see(std::optional<std::int64_t> position, Instant now);
    // The word is put into OUT. No target: it is not known.
    void begin(std::optional<Target> target, Instant now);

    const std::optional<Target> &target() const { return m_target; }
    // The position has jumped, or so much time has passed that the word must have acted where no jump can be
    // seen.
    bool hasActed(Instant now, const K3Timing &timing) const;
    // There is nothing more to wait for.
    bool isOver(Instant now, const K3Timing &timing) const;
    Said says() const;
    // The position has jumped there.
    bool hasArrived() const { return m_hasArrived; }

private:
    struct Seen
    {
        std::int64_t position = 0;
        Instant at{};
    };

    std::int64_t way(std::int64_t from, std::int64_t to) const;
    bool isNear(std::int64_t position, double steps) const;
    bool showsOnlyZero(Instant now, const K3Timing &timing) const;
    void jumpTo(std::int64_t position, double reach);
    bool mayBeEndOfRange(std::int64_t before, std::int64_t position, double reach) const;

    std::optional<Target> m_target;
    Instant m_begunAt{};
    int m_cycles = 0; // since then
    std::optional<Seen> m_last;
    bool m_isAsked = false; // the word was put into OUT, and it is not over
    std::optional<double>
        m_speed; // steps per us: the last one, and while it is asked the fastest; empty: not known
    std::int64_t m_direction = 0; // of the last movement
    Instant m_zeroSince{};
    bool m_hasJumped = false;
    bool m_hasArrived = false; // by a jump
    bool m_stoodThere = false; // the position was the target all the time
    bool m_couldHide = false;  // it was so near the target that the shaft could have turned there
};

// Empty where preset, offset, coding or mode of the encoder, or the range in which it counts, are not known.
std::optional<K3PresetProof::Target> presetTarget(const DeviceDescription &device,
                                                  const K3Knowledge &knowledge);

} // namespace codewheel
