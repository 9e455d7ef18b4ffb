// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "recording/recording_trigger.h"

namespace codewheel {

// The trigger typed as `text` (recording/trigger_text.h). Its place is written as any PLACE, or is a bus; an
// encoder is asked so that it shows what the trigger waits for. Refused if it has no such bit.
Checked<RecordingTrigger> triggerMeant(const Call &call, const QString &text);

} // namespace codewheel
