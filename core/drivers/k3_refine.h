// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/job_account.h"
#include "drivers/job_steps.h"
#include "drivers/k3_encoder.h"

namespace codewheel {

// What a value that was read changes in the steps to come: what is already there is left out, and so told by
// the account; steps are sent minus 1 where the encoder counts so; a preset is programmed again only where it
// is used up (FRABA manual 5.4.1).
void refine(JobSteps<K3Step> &steps, JobAccount &account, const Job &job, const K3Encoder &encoder,
            ParameterValue read);

} // namespace codewheel
