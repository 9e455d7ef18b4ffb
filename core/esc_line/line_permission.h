// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/job.h"
#include "encoder/refusal.h"
#include "esc/esc_request.h"
#include "esc_line/line_snapshot.h"

namespace codewheel {

// Whether a job may begin, or what was typed may be sent, as the line is now: the port is there, it is polled
// (jobs), and writing is allowed where something is written. The window asks it of the latest snapshot to
// answer at once; the runner asks it again when the command arrives. `place` is that of the encoder, as
// people are told it, `link` the name of the link.
Result<void> mayStart(const LineState &line, const Job &job, const QString &place, const QString &link);
Result<void> maySend(const LineState &line, const esc::Request &request, const QString &link);

} // namespace codewheel
