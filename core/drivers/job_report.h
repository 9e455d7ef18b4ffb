// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/event.h"
#include "encoder/message.h"

#include <vector>

namespace codewheel {

// What the message log says when a job has ended: what was done even if the job failed later, why it failed,
// and whether the encoder was left in parameterization. Without time and place.
std::vector<Message> doubtReport(const InDoubt &doubt, const DeviceDescription &device); // part of it
std::vector<Message> jobReport(const Job &job, const Outcome &outcome, const DeviceDescription &device);

} // namespace codewheel
