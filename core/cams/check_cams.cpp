// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/check_cams.h"

namespace codewheel {

Result<void> checkCamProgramNumber(std::int64_t number)
{
    if (number < 1 || number > CamProgram::programs)
        return refuse(RefusalKind::badInput, RefusalId::camProgramOutOfRange, {number});
    return {};
}

Result<void> check(const CamProgram &program, std::int64_t largestPosition)
{
    if (auto checked = checkCamProgramNumber(program.number); !checked)
        return checked;
    if (program.shift > CamProgram::largestShift)
        return refuse(RefusalKind::badInput, RefusalId::camShiftOutOfRange, {std::int64_t{program.shift}});
    for (std::size_t n = 0; n < CamProgram::cams; ++n)
        for (const std::int64_t position : {program.cam[n].start, program.cam[n].stop})
            if (position < 0 || position > largestPosition)
                return refuse(RefusalKind::badInput, RefusalId::camPositionTooLarge,
                              {static_cast<std::int64_t>(n), position, largestPosition});
    return {};
}

} // namespace codewheel
