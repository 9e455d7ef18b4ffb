// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/k3/k3_step.h"

namespace codewheel {

// What it takes to name an error: the step it answered, and what was taken before.
struct K3Circumstances
{
    const DeviceDescription &device;
    const K3Step &step;
    bool isConfirmed = false;         // the number of the step was already in IN
    const ParameterValues &confirmed; // since the last run
    const ParameterValues &written;
    bool inCamMode = false;           // as far as known
    bool mayBeInCamMode = false;      // nobody has seen its mode
    bool foundParameterizing = false; // the encoder was in a parameterization before the job
    bool foundInError = false;        // or in the error state
};

// What the error in IN means, named for the user (FRABA manual 10.6, Baumer manual 7; for cams FRABA manual
// 5.4.4).
Refusal k3Refusal(const K3Circumstances &at, Word in);

// The words that only ask whether the encoder understands cams.
bool onlyAsksForCams(const K3Step &step);

} // namespace codewheel
