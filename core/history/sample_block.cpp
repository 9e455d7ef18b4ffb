// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/sample_block.h"

namespace codewheel {
namespace {

constexpr std::int64_t words = std::int64_t{1} << 32;

bool fits32(std::int64_t distance)
{
    return distance >= 0 && distance < words;
}

} // namespace

SampleBlock::SampleBlock(const Sample &first)
    : m_begin(first.at)
    , m_base(fits32(first.value) ? 0 : first.value - words / 2)
    , m_all(of(static_cast<std::uint32_t>(first.value - m_base)))
{
    append(first);
}

bool SampleBlock::takes(const Sample &sample) const
{
    return size() < capacity && fits32(sample.value - m_base) && fits32((sample.at - m_begin).count());
}

void SampleBlock::append(const Sample &sample)
{
    const auto value = static_cast<std::uint32_t>(sample.value - m_base);
    if (size() == m_times.capacity())
        grow();
    m_times.push_back(static_cast<std::uint32_t>((sample.at - m_begin).count()));
    m_values.push_back(value);
    include(value);
}

// To four times the room: most blocks are full in the end, and those of a value that stands stay small.
void SampleBlock::grow()
{
    std::size_t room = std::clamp(4 * size(), fan, capacity);
    m_times.reserve(room);
    m_values.reserve(room);
    for (auto &level : m_levels)
        level.reserve(room = (room + fan - 1) / fan);
}

void SampleBlock::include(std::uint32_t value)
{
    m_all.include(of(value));
    std::size_t index = size() - 1;
    for (auto &level : m_levels) {
        index /= fan;
        if (index == level.size())
            level.push_back(of(value));
        else
            level[index].include(of(value));
    }
}

std::size_t SampleBlock::indexAt(Instant at) const
{
    if (at <= m_begin)
        return 0;
    const auto distance = (at - m_begin).count();
    if (!fits32(distance))
        return size();
    return static_cast<std::size_t>(std::ranges::lower_bound(m_times, static_cast<std::uint32_t>(distance)) -
                                    m_times.begin());
}

Summary SampleBlock::summary(std::size_t begin, std::size_t end) const
{
    if (begin == 0 && end == size())
        return summary();
    Summary32 all = of(m_values[begin]);
    gather(all, begin, end);
    return of(all);
}

// Samples up to a multiple of 32 at either end, then summaries of 32 up to a multiple of 1024, and so on.
void SampleBlock::gather(Summary32 &all, std::size_t begin, std::size_t end) const
{
    const auto climb = [&](const auto &at) {
        for (; begin < end && begin % fan != 0; ++begin)
            all.include(at(begin));
        for (; begin < end && end % fan != 0; --end)
            all.include(at(end - 1));
        begin /= fan;
        end /= fan;
    };
    climb([this](std::size_t index) { return of(m_values[index]); });
    for (std::size_t level = 0; level + 1 < m_levels.size(); ++level)
        climb([&summaries = m_levels[level]](std::size_t index) { return summaries[index]; });
    for (; begin < end; ++begin)
        all.include(m_levels.back()[begin]);
}

Moments SampleBlock::moments(std::size_t begin, std::size_t end) const
{
    if (begin >= end)
        return {};
    const auto base = static_cast<double>(m_values[begin]);
    double sum = 0;
    double squares = 0;
    for (std::size_t index = begin; index < end; ++index) {
        const double stood = m_times[index + 1] - m_times[index];
        const double distance = m_values[index] - base;
        sum += stood * distance;
        squares += stood * distance * distance;
    }
    return {static_cast<double>(m_base) + base, static_cast<double>(m_times[end] - m_times[begin]), sum,
            squares};
}

std::size_t SampleBlock::bytes() const
{
    std::size_t bytes = sizeof *this + (m_times.capacity() + m_values.capacity()) * sizeof(std::uint32_t);
    for (const auto &level : m_levels)
        bytes += level.capacity() * sizeof(Summary32);
    return bytes;
}

} // namespace codewheel
