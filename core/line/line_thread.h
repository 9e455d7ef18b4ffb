// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "encoder/sleep_watch.h"
#include "line/line_settings.h"

#include <future>
#include <thread>

namespace codewheel {

class ByteLink;
class LineRunner;

// The thread of a serial line: opens the link, works, and closes the link at its end, which interrupts a call
// that blocks in the link. So all of the link's life is in one thread. Runner and link must outlive it.
class LineThread
{
public:
    // After the computer slept the runner is told before the next request.
    LineThread(LineRunner &runner, ByteLink &link, const LineSettings &settings,
               SleepWatch::Slept slept = SleepWatch::ofThisComputer);
    ~LineThread();

    LineThread(const LineThread &) = delete;
    LineThread &operator=(const LineThread &) = delete;

    // How opening the link ended; waits for it, once. After a refusal the thread does nothing more.
    Result<void> opened() { return m_opened.get(); }

private:
    ByteLink &m_link;
    std::future<Result<void>> m_opened;
    std::jthread m_thread;
};

} // namespace codewheel
