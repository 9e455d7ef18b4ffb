// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace codewheel {

// The words of a line of a CAN log, one after the other.
class CanLogWords
{
public:
    explicit CanLogWords(std::string_view line)
        : m_rest(line)
    {}

    std::string_view next();       // empty: there is no more
    std::string_view rest() const; // without the blanks before it
    bool isAtEnd() const { return rest().empty(); }

private:
    std::string_view m_rest;
};

// Exactly these digits, which fit into 32 bits. Empty for anything else.
std::optional<std::uint32_t> numberIn(std::string_view digits, int base);
// Of one hexadecimal digit, the length of a frame: from 9 to F eight bytes. Empty for anything else.
std::optional<std::uint8_t> lengthCode(std::string_view digit);
// "1544106679.432583", "-0.0001", "12": below 10^12 s, which are more than 10 000 years; what is behind the
// sixth decimal is cut off.
std::optional<Instant> secondsIn(std::string_view text);
// Whatever the case of the letters.
bool beginsWith(std::string_view text, std::string_view beginning);

} // namespace codewheel
