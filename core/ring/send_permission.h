// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "ring/snapshot.h"

namespace codewheel {

// Whether anything may be sent to a device now: the bus runs, writing is allowed, the device is in the ring,
// and no job holds its OUT word. The window asks it of the latest snapshot to answer at once; the runner asks
// it again when the command arrives. `place` is where it stands, as people are told it; `whenHeld` is
// jobRunning or wordHeldByJob.
Result<void> maySend(const Snapshot &ring, std::size_t device, const QString &place, RefusalId whenHeld);

// Whether the master may be asked now for a service that changes what the ring does: read it in, switch a
// segment, confirm diagnostics, keep another configuration. Asked twice like the above. Stop and ALARM STOP
// need no permission.
Result<void> mayChangeRing(const Snapshot &ring);

} // namespace codewheel
