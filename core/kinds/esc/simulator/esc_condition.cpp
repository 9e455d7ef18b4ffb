// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/esc_condition.h"

namespace codewheel {
namespace {

std::uint32_t numberedBit(int number, bool set)
{
    return set ? 1U << number : 0U;
}

} // namespace

// A flat battery alone is not a general fault: the manual's own 4000.
std::uint32_t escAlarms(const EscCondition &condition, const EscMotion &motion)
{
    const bool generalFault =
        condition.temperatureExceeded || condition.batteryLimit || condition.lightControl || motion.tooFast;
    return numberedBit(15, condition.temperatureExceeded) | numberedBit(14, condition.batteryFlat) |
           numberedBit(12, generalFault) | numberedBit(0, condition.positionError);
}

// A position warning is taken to mean "one of the two limit switches" (assumed).
std::uint32_t escWarnings(const EscCondition &condition, const EscMotion &motion)
{
    return numberedBit(15, motion.standsStill) |
           numberedBit(14, motion.aboveUpperLimit || motion.belowLowerLimit) |
           numberedBit(13, motion.aboveUpperLimit) | numberedBit(12, motion.belowLowerLimit) |
           numberedBit(11, motion.turnsCcw) | numberedBit(5, motion.atPreset) |
           numberedBit(4, condition.batteryLimit) | numberedBit(1, condition.lightControl) |
           numberedBit(0, motion.tooFast);
}

} // namespace codewheel
