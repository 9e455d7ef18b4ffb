// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/check_cams.h"

#include <numeric>

namespace codewheel {

std::vector<unsigned> programNumbers(const CamAbilities &abilities)
{
    std::vector<unsigned> numbers(abilities.programs);
    std::iota(numbers.begin(), numbers.end(), 1U);
    return numbers;
}

Result<void> checkCamProgramNumber(std::int64_t number, const CamAbilities &abilities)
{
    if (number < 1 || number > abilities.programs)
        return refuse(RefusalKind::badInput, RefusalId::camProgramOutOfRange,
                      {number, std::int64_t{abilities.programs}});
    return {};
}

Result<void> check(const Cam &cam, std::size_t number, const CamAbilities &abilities,
                   std::int64_t largestPosition)
{
    const auto which = static_cast<std::int64_t>(number);
    if (number >= abilities.cams && cam != Cam())
        return refuse(RefusalKind::badInput, RefusalId::camOutOfRange,
                      {which, static_cast<std::int64_t>(abilities.cams) - 1});
    for (const std::int64_t position : {cam.start, cam.stop, cam.hysteresis})
        if (position < 0 || position > largestPosition)
            return refuse(RefusalKind::badInput, RefusalId::camPositionTooLarge,
                          {which, position, largestPosition});
    if (cam.start > cam.stop && !abilities.isCyclic)
        return refuse(RefusalKind::badInput, RefusalId::camThroughZero, {which});
    if ((cam.hysteresis > 0 && !abilities.hasHysteresis) || (cam.isInverted && !abilities.hasPolarity))
        return refuse(RefusalKind::badInput, RefusalId::camHasMore, {which});
    return {};
}

Result<void> check(const CamProgram &program, const CamAbilities &abilities, std::int64_t largestPosition)
{
    if (auto checked = checkCamProgramNumber(program.number, abilities); !checked)
        return checked;
    if (program.shift > 0 && !abilities.hasShift)
        return refuse(RefusalKind::badInput, RefusalId::camHasNoShift, {std::int64_t{program.shift}});
    if (program.shift > CamProgram::largestShift)
        return refuse(RefusalKind::badInput, RefusalId::camShiftOutOfRange, {std::int64_t{program.shift}});
    for (std::size_t n = 0; n < CamProgram::cams; ++n)
        if (auto checked = check(program.cam[n], n, abilities, largestPosition); !checked)
            return checked;
    return {};
}

} // namespace codewheel
