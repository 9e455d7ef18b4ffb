// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_log_reader.h"
#include "can/can_log_writer.h"

#include <QDateTime>

#include <string>
#include <vector>

namespace codewheel {

// What is read of a log.
struct ReadLog
{
    std::vector<CanFrame> frames{};
    std::vector<std::pair<std::int64_t, CanLogFault>> faults{};
    std::int64_t canFdFrames = 0;
    std::optional<CanLogTimes> times{};
    bool isSince1970 = false;

    // Each as it is written, without time, interface and end of line: "185#8813".
    std::vector<std::string> written() const
    {
        std::vector<std::string> lines;
        for (const CanFrame &frame : frames) {
            const std::string line = canLogLine(frame);
            const auto begin = line.rfind(' ') + 1;
            lines.push_back(line.substr(begin, line.size() - begin - 1));
        }
        return lines;
    }
    std::vector<std::int64_t> microseconds() const
    {
        std::vector<std::int64_t> all;
        for (const CanFrame &frame : frames)
            all.push_back(frame.time.value_or(Instant(-1)).count());
        return all;
    }
};

inline ReadLog readLog(const std::string &text, std::optional<CanLogTimes> meant = {},
                       std::size_t atOnce = std::string::npos)
{
    ReadLog log;
    CanLogReader reader([&](const CanFrame &frame) { log.frames.push_back(frame); },
                        [&](std::int64_t line, CanLogFault fault) { log.faults.emplace_back(line, fault); },
                        meant);
    for (std::size_t at = 0; at < text.size(); at += std::min(atOnce, text.size()))
        reader.read(std::string_view(text).substr(at, atOnce));
    reader.finish();
    log.canFdFrames = reader.canFdFrames();
    log.times = reader.times();
    log.isSince1970 = reader.isSince1970();
    return log;
}

inline std::int64_t localMicroseconds(const QDate &date, const QTime &time)
{
    return QDateTime(date, time).toMSecsSinceEpoch() * 1'000;
}

} // namespace codewheel
