// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/file_value.h"
#include "kinds/canopen/eds/ini_text.h"

#include <charconv>

namespace codewheel::canopen {
namespace {

constexpr int ofHexadecimal = 16;
constexpr int ofDecimal = 10;
constexpr int ofOctal = 8;

bool isHexPrefixed(std::string_view text)
{
    return text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
}

// All of the digits. Empty: there are others, or none.
std::optional<std::uint64_t> digitsIn(std::string_view text, int base, bool *isTooLarge = nullptr)
{
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    if (text.empty() || end != text.data() + text.size())
        return std::nullopt;
    if (error == std::errc::result_out_of_range && isTooLarge != nullptr)
        *isTooLarge = true;
    return error == std::errc() ? std::optional(number) : std::nullopt;
}

// "5ULL", as a number is written in C.
std::string_view withoutSuffix(std::string_view text)
{
    const std::size_t last = text.find_last_not_of("uUlL");
    return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

// "5.0"
std::string_view withoutZeroFraction(std::string_view text)
{
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos || text.find_first_not_of('0', point + 1) != std::string_view::npos)
        return text;
    return text.substr(0, point);
}

} // namespace

ReadNumber readFileNumber(std::string_view text)
{
    ReadNumber number;
    text = trimmed(text);
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
        number.isNegative = text.front() == '-';
        text = trimmed(text.substr(1));
    }
    if (const auto plain = withoutSuffix(text); plain.size() < text.size()) {
        number.fault = EdsFault::suffix;
        text = plain;
    }
    if (isHexPrefixed(text)) {
        number.isHexadecimal = true;
        number.magnitude = digitsIn(text.substr(2), ofHexadecimal, &number.isTooLarge);
        return number;
    }
    if (const auto whole = withoutZeroFraction(text); whole.size() < text.size()) {
        number.fault = EdsFault::fraction;
        text = whole;
    }
    number.magnitude = digitsIn(text, ofDecimal, &number.isTooLarge);
    const auto asOctal = text.size() > 1 && text.front() == '0' ? digitsIn(text, ofOctal) : std::nullopt;
    if (asOctal && asOctal != number.magnitude && !number.fault)
        number.fault = EdsFault::leadingZero;
    return number;
}

} // namespace codewheel::canopen
