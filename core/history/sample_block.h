// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/moments.h"
#include "history/sample.h"

#include <array>
#include <cstddef>
#include <vector>

namespace codewheel {

// Up to 4096 samples, oldest first, in 8.52 bytes each: time and value as 32-bit distances from where the
// block begins, and over them the summaries of 32, of 1024 and of all samples, so that that of any range is
// found in a few steps.
class SampleBlock
{
public:
    static constexpr std::size_t capacity = 4096;
    static constexpr double bytesPerSample = 8 + 16 * (1 / 32. + 1 / 1024.); // once it is full

    // The values that fit are the 32-bit words if the first one is such a word, else those no further from it
    // than 2^31.
    explicit SampleBlock(const Sample &first);

    // Whether it has room, the value fits, and the time is within 71 minutes of the first one.
    bool takes(const Sample &sample) const;
    // One that it takes, no older than the last one.
    void append(const Sample &sample);
    // The last one, whose value still stood then; no later than it takes a sample.
    void holdUntil(Instant at) { m_times.back() = static_cast<std::uint32_t>((at - m_begin).count()); }

    std::size_t size() const { return m_times.size(); }
    Sample operator[](std::size_t index) const { return {time(index), value(m_values[index])}; }
    Instant first() const { return m_begin; }
    Instant last() const { return time(size() - 1); }
    // The first sample no older than that; size(): none.
    std::size_t indexAt(Instant at) const;

    Summary summary() const { return of(m_all); } // in the block itself: it takes no look at the samples
    // Of the samples from `begin` up to, but not including, `end`, which is larger.
    Summary summary(std::size_t begin, std::size_t end) const;

    // Of the samples from `begin` up to, but not including, `end`, each until the next one; the last one of
    // all has none.
    Moments moments(std::size_t begin, std::size_t end) const;

    std::size_t bytes() const; // of memory

private:
    struct Summary32
    {
        std::uint32_t least;
        std::uint32_t greatest;
        std::uint32_t always; // bits that are 1 in all
        std::uint32_t ever;   // bits that are 1 in any

        void include(const Summary32 &other)
        {
            least = std::min(least, other.least);
            greatest = std::max(greatest, other.greatest);
            always &= other.always;
            ever |= other.ever;
        }
    };
    static constexpr std::size_t fan = 32; // summaries of a level below one of the next

    Instant time(std::size_t index) const { return m_begin + Instant(m_times[index]); }
    std::int64_t value(std::uint32_t offset) const { return m_base + offset; }
    static Summary32 of(std::uint32_t value) { return {value, value, value, value}; }
    Summary of(const Summary32 &all) const
    {
        return {{value(all.least), value(all.greatest)}, all.always, all.ever};
    }
    void grow();
    void include(std::uint32_t value);
    void gather(Summary32 &all, std::size_t begin, std::size_t end) const;

    Instant m_begin;
    std::int64_t m_base;
    Summary32 m_all;
    std::vector<std::uint32_t> m_times; // microseconds since m_begin
    std::vector<std::uint32_t> m_values;
    std::array<std::vector<Summary32>, 2> m_levels;
};

} // namespace codewheel
