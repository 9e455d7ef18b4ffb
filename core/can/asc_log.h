// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_log_line.h"

#include <string_view>

namespace codewheel {

// What the header of an asc file says of its lines.
struct AscHeader
{
    enum class Times : std::uint8_t {
        fromDate,       // "absolute"
        fromLineBefore, // "relative"
        ofDay,          // as BUSMASTER writes, which says neither
    };

    Times times = Times::fromDate;
    int base = 16;                 // of identifiers and data
    std::optional<Instant> date{}; // its own, or that of its first trigger block; since 1970
};

// Lines as Vector's programs, log2asc and BUSMASTER write them: "0.020000 1 185x Rx d 2 88 13".
class AscLog
{
public:
    // Whether it is its business: it begins with a time, a word of the header, or a comment.
    static bool isItsLine(std::string_view text);
    CanLogLine line(std::string_view text);
    const AscHeader &header() const { return m_header; }

private:
    CanLogLine takesHeader(std::string_view text);
    CanLogLine takesDate(std::string_view text);
    CanLogLine takesBase(std::string_view text);
    CanLogLine timed(std::string_view text) const;
    CanLogLine frame(std::string_view id, std::string_view behind) const;

    AscHeader m_header;
    bool m_hasBlamedDate = false;
    bool m_hasBegun = false; // a header or a frame was there: what else has a time is an event
};

} // namespace codewheel
