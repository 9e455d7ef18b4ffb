// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_account.h"
#include "jobs/job_steps.h"
#include "kinds/interbus/k3/k3_encoder.h"

namespace codewheel {

// How a value that was read changes the remaining steps: what is already there is left out, and noted in the
// account; steps are sent minus 1 if the encoder counts that way; a preset is programmed again only if it is
// used up (FRABA manual 5.4.1).
void refine(JobSteps<K3Step> &steps, JobAccount &account, const Job &job, const K3Encoder &encoder,
            const ParameterValue &read);

} // namespace codewheel
