// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/snapshot.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// Whether anything may be sent to a device now: the bus runs, writing is allowed, the device is in the ring,
// and no job holds its OUT word. The window checks the latest snapshot to answer at once; the runner checks
// again when the command arrives. `place` is where it is, as shown to people; `whenHeld` is jobRunning or
// wordHeldByJob.
Result<void> maySend(const Snapshot &ring, std::size_t device, const QString &place, RefusalCode whenHeld);

// Whether the master may now be asked for a service that changes what the ring does: read it in, switch a
// segment, confirm diagnostics, store another configuration. Checked twice like the above. Stop and ALARM
// STOP need no permission.
Result<void> mayChangeRing(const Snapshot &ring);

} // namespace codewheel
