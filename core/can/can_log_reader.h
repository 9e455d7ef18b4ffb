// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/asc_log.h"
#include "can/can_log_clock.h"
#include "can/candump_log.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace codewheel {

// Reads a log of CAN frames in any of the forms that are known (docs/manual/can-logs.md), piece by piece, and
// passes on what it has read. It keeps no more than some thousand frames: those that come before it is known
// what their times are.
class CanLogReader
{
public:
    // In the order of the log.
    using TakeFrame = std::function<void(const CanFrame &)>;
    // A line that was not read, or only in part, with its number, from 1 on. Not always in their order.
    using TakeFault = std::function<void(std::int64_t line, CanLogFault fault)>;

    // `meant`: what the times are, whatever the log says.
    CanLogReader(TakeFrame takeFrame, TakeFault takeFault, std::optional<CanLogTimes> meant = {});

    void read(std::string_view bytes); // as they follow each other in the file
    void finish();                     // there are no more: this ends the last line
    void breakOff();                   // there may be more: a line that has begun is left out

    std::int64_t frames() const { return m_frames; }
    std::int64_t canFdFrames() const { return m_canFdFrames; }
    // What the times are. Empty: no frame had one.
    std::optional<CanLogTimes> times() const { return m_clock.times(); }
    bool isSince1970() const { return m_clock.isSince1970(); } // otherwise since the first frame

private:
    struct Waiting
    {
        std::optional<CanFrame> frame;
        CanLogStamp stamp;
        std::int64_t number;
    };

    void gather(std::string_view part);
    void endLine();
    void readLine(std::string_view text);
    CanLogLine lineOf(std::string_view text);
    void blame(CanLogFault fault, std::int64_t line);
    void pass(const Waiting &line);
    void passAll();

    TakeFrame m_takeFrame;
    TakeFault m_takeFault;
    CanLogClock m_clock;
    CandumpLog m_candump;
    AscLog m_asc;
    std::string m_part; // of a line whose end has not come yet
    bool m_isTooLong = false;
    bool m_mayBeExplained = false; // candump -e tells below an error frame what it means
    std::int64_t m_line = 0;
    std::int64_t m_frames = 0;
    std::int64_t m_canFdFrames = 0;
    std::vector<Waiting> m_waiting;
};

} // namespace codewheel
