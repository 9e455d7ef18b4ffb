// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// Decides which data cycles are faulty: as often as asked for, at moments that look random and are the same
// in every run. Used by SimulatedMaster.
class SegmentErrors
{
public:
    // Of 1000 cycles. To be asked once per cycle and segment.
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
