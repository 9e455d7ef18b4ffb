// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_snapshot.h"
#include "kinds/esc/protocol/esc_request.h"
#include "vocabulary/job.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// Whether a job may begin, or what was typed may be sent, in the current state of the line: the port is
// there, it is polled (for jobs), and writing is allowed if something is written. The window checks the
// latest snapshot to answer at once; the runner checks again when the command arrives. `place` is that of the
// encoder, as shown to people, `link` the name of the link.
Result<void> mayStart(const LineState &line, const Job &job, const QString &place, const QString &link);
Result<void> maySend(const LineState &line, const esc::Request &request, const QString &link);

} // namespace codewheel
