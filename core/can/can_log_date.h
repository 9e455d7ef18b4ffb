// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <optional>
#include <string>
#include <string_view>

namespace codewheel {

// The dates of the lines of a log in local time. Lines of the same minute follow each other, so each minute
// is worked out once.
class CanLogDates
{
public:
    // "2018-12-06 14:31:19.432583", since 1970. In an hour that comes twice the time goes on from the line
    // before; in one that is left out it goes on from the time before the change.
    std::optional<Instant> at(std::string_view text);

private:
    void look(std::string_view digits);

    std::string m_minute;
    std::optional<Instant> m_first;
    Instant m_last{}; // the second one, in an hour that comes twice
    Instant m_before{};
};

// The date in the header of an asc file, in local time, as English and German programs write it, behind the
// day of the week: "Thu Dec 06 02:31:19.123 pm 2018", "Don Dez 6 14:31:19 2018", "Do. Dez. 6
// 02:31:19 nachm. 2018". Empty for anything else.
std::optional<Instant> ascDate(std::string_view text);
// When the day of that time began.
Instant midnightBefore(Instant at);

} // namespace codewheel
