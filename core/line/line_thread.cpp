// SPDX-License-Identifier: GPL-3.0-or-later
#include "line/line_thread.h"

#include "line/byte_link.h"
#include "line/line_runner.h"

namespace codewheel {
namespace {

// A stop is noticed after this long, even on a quiet line or without a port.
constexpr std::chrono::milliseconds longestWait{50};

void work(const std::stop_token &stop, LineRunner &runner, const ByteLink &link, SleepWatch sleep)
{
    while (!stop.stop_requested()) {
        if (const auto slept = sleep.sleptSinceLast(); slept.count() > 0)
            runner.slept(slept);
        runner.run(link.now() + longestWait);
    }
}

} // namespace

LineThread::LineThread(LineRunner &runner, ByteLink &link, const LineSettings &settings,
                       SleepWatch::Slept slept)
    : m_link(link)
{
    std::promise<Result<void>> opening;
    m_opened = opening.get_future();
    m_thread = std::jthread([&runner, &link, settings, sleep = SleepWatch(std::move(slept)),
                             told = std::move(opening)](const std::stop_token &stop) mutable {
        auto opened = link.open(settings);
        const bool isOpen = opened.has_value();
        told.set_value(std::move(opened));
        if (!isOpen)
            return;
        work(stop, runner, link, sleep);
        runner.finish();
        link.close();
    });
}

LineThread::~LineThread()
{
    m_thread.request_stop();
    m_link.interrupt();
}

} // namespace codewheel
