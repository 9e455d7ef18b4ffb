// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_log_date.h"
#include "can/can_log_line.h"

namespace codewheel {

// Lines as candump writes them: into its log file ("(1544106679.432583) can0 185#88130000") and on its screen
// ("  can0  057   [8]  C7 35 ..", with or without a time).
class CandumpLog
{
public:
    CanLogLine line(std::string_view text);
    // Its frame alone: "185#88130000", "100#R8"; of CAN FD, "185##0..", it is not read.
    static CanLogLine frame(std::string_view text);

private:
    CanLogDates m_dates;
};

} // namespace codewheel
