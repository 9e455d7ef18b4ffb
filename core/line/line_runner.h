// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line/byte_link.h"
#include "line/line_command.h"
#include "line/line_event.h"
#include "line/line_snapshot.h"

#include <memory>
#include <vector>

namespace codewheel {

// Owns the line: one request at a time. What was typed goes first, then a scan, then the devices in turn: of
// those that want something, the one whose turn is longest ago. Has no thread of its own: run() is called by
// LineThread, by the command line, or by a test with a simulated line. post(), takeEvents(), takeLatest():
// any thread; all else by the caller of run().
//
// It begins in Watch, where only reads are sent, and without polling. When the port is gone it says so once,
// ends the jobs, and tries each second to open it again at the same adapter, and at no other unasked.
class LineRunner
{
public:
    // The link is open with these settings.
    LineRunner(ByteLink &link, const LineSettings &settings, const esc::Timing &timing);
    ~LineRunner();

    // Works until `until` on the link's clock.
    void run(Instant until);
    // The computer slept so long: the jobs end, nothing that was typed is sent any more, and the line is in
    // Watch.
    void slept(std::chrono::milliseconds duration);
    // Before the link is closed: carries out what was posted, and ends the jobs.
    void finish();

    void post(LineCommand command);
    std::vector<LineEvent> takeEvents();
    // The newest snapshot; nothing if none came since.
    std::shared_ptr<const LineSnapshot> takeLatest();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
