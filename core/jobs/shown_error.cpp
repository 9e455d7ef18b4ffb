// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/shown_error.h"

#include "kinds/interbus/k3/k3_refusal.h"

namespace codewheel {

Refusal shownError(const DeviceDescription &device, const Reading &reading)
{
    const unsigned number = reading.errorNumber.value_or(0);
    if (number == 0)
        return {RefusalKind::device, RefusalId::noValidPosition, {reading.in}};
    if (device.profile == Profile::la66)
        return {RefusalKind::device, RefusalId::magnetOutOfRange, {reading.in}};
    const K3Step step = k3Step(StepKind::word, k3::normalRunning);
    const ParameterValues none;
    return k3Refusal({.device = device,
                      .step = step,
                      .confirmed = none,
                      .written = none,
                      .inCamMode = reading.mode == Mode::cam},
                     reading.in);
}

} // namespace codewheel
