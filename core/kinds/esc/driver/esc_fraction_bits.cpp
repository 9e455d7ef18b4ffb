// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_fraction_bits.h"

#include "kinds/esc/protocol/esc_refusals.h"
#include "kinds/esc/protocol/esc_scaling.h"

namespace codewheel {

ReadParameters fractionBitsJob()
{
    return {{Parameter::scalingFactor, Parameter::steps, Parameter::measuringRange}};
}

Result<int> fractionBitsOf(const Outcome &outcome)
{
    if (!outcome.result)
        return tl::unexpected(outcome.result.error());
    const auto read = [&](Parameter parameter) {
        return static_cast<std::uint32_t>(valueOf(outcome.read, parameter).value_or(0));
    };
    const std::uint32_t factor = read(Parameter::scalingFactor);
    const std::uint32_t steps = read(Parameter::steps);
    const std::uint32_t range = read(Parameter::measuringRange);
    if (const auto bits = esc::fractionBitsFrom(factor, steps, range))
        return *bits;
    return refuse(RefusalKind::device, EscRefusalId::factorFitsNothing,
                  {Word{factor}, std::int64_t{steps}, std::int64_t{range}});
}

} // namespace codewheel
