// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/esc_condition.h"

namespace codewheel {
namespace {

std::uint32_t bit(int number, bool set)
{
    return set ? 1U << number : 0U;
}

} // namespace

// A flat battery alone is not a general fault: the manual's own 4000.
std::uint32_t escAlarms(const EscCondition &condition, const EscMotion &motion)
{
    const bool generalFault =
        condition.temperatureExceeded || condition.batteryLimit || condition.lightControl || motion.tooFast;
    return bit(15, condition.temperatureExceeded) | bit(14, condition.batteryFlat) | bit(12, generalFault) |
           bit(0, condition.positionError);
}

// A position warning is taken to mean "one of the two limit switches" (assumed).
std::uint32_t escWarnings(const EscCondition &condition, const EscMotion &motion)
{
    return bit(15, motion.standsStill) | bit(14, motion.aboveUpperLimit || motion.belowLowerLimit) |
           bit(13, motion.aboveUpperLimit) | bit(12, motion.belowLowerLimit) | bit(11, motion.turnsCcw) |
           bit(5, motion.atPreset) | bit(4, condition.batteryLimit) | bit(1, condition.lightControl) |
           bit(0, motion.tooFast);
}

} // namespace codewheel
