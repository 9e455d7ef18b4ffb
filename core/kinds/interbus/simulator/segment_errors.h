// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// Decides which data cycles are faulty: as many as requested, at moments that look random but are the same in
// every run. Used by SimulatedMaster.
class SegmentErrors
{
public:
    // Per 1000 cycles. To be called once per cycle and segment.
    bool strikes(int perThousand)
    {
        // Knuth's MMIX generator; its upper bits are good enough for this.
        m_random = m_random * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
        return static_cast<int>((m_random >> 33) % 1'000) < perThousand;
    }

private:
    std::uint64_t m_random = 1;
};

} // namespace codewheel
