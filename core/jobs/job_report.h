// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/event.h"
#include "vocabulary/message.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace codewheel {

// What the message log says when a job has ended: what was done even if the job failed later, why it failed,
// and whether the encoder was left in parameterization or in another mode. Without time and place. `known`:
// of the encoder, once it has ended.
std::vector<Message> jobReport(const Job &job, const Outcome &outcome, const DeviceDescription &device,
                               const ParameterValues &known = {});

// That a job that was cut off has left the encoder in this mode.
Message leftModeMessage(const LeftMode &left);
// Empty: it has left it in none but the one it was in, or the reason why it failed says that and what to do.
std::optional<Message> leftModeReport(const Outcome &outcome);

// "Steps = 255, position"; empty: nothing.
QString doubtText(const InDoubt &doubt, const DeviceDescription &device);

// What was sent and not answered, by a job or by hand.
std::vector<Message> doubtReport(const InDoubt &doubt, const DeviceDescription &device);

// The part of it about what was sent and not answered, in words; empty: nothing.
QStringList doubtSentences(const InDoubt &doubt, const DeviceDescription &device);

} // namespace codewheel
