// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

namespace codewheel::bench {

// Positions of a shaft that wanders by chance, up to a few steps in each cycle: at every zoom its curve looks
// alike, so that what is compared is the number of samples alone.
class NoisyShaft
{
public:
    std::int64_t next() { return m_position += m_step(m_chance); }

private:
    std::mt19937 m_chance{1};
    std::uniform_int_distribution<std::int64_t> m_step{-9, 9};
    std::int64_t m_position = 1 << 24;
};

} // namespace codewheel::bench
