// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/simulated_device.h"

namespace codewheel {

// A device that nobody simulates, such as a digital module or a drive: IN shows the OUT word of the cycle
// before, so that it can be seen that it arrived, as far as it has words.
class SimulatedWords final : public SimulatedDevice
{
public:
    SimulatedWords(int inWords, int outWords)
        : m_mask(maskOf(inWords) & maskOf(outWords))
    {}

    Word cycle(Word out) override { return std::exchange(m_in, out & m_mask); }

private:
    static constexpr Word maskOf(int words) { return words == 0 ? 0 : words == 1 ? 0xFFFF : ~Word{0}; }

    Word m_mask;
    Word m_in = 0; // prepared for the next cycle
};

} // namespace codewheel
