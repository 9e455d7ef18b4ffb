// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_words.h"

#include "can/can_frame.h"

#include <algorithm>
#include <charconv>

namespace codewheel {
namespace {

constexpr std::string_view logBlanks = " \t\r\v\f";

constexpr std::size_t mostDigitsOfSeconds = 12;

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

char inLowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

Instant decimalsIn(std::string_view digits)
{
    constexpr std::int64_t tenth = 100'000;
    std::int64_t sum = 0;
    std::size_t i = 0;
    for (std::int64_t unit = tenth; unit > 0 && i < digits.size(); unit /= 10)
        sum += (digits[i++] - '0') * unit;
    return Instant(sum);
}

} // namespace

std::string_view CanLogWords::rest() const
{
    const auto begin = m_rest.find_first_not_of(logBlanks);
    return begin == std::string_view::npos ? std::string_view() : m_rest.substr(begin);
}

std::string_view CanLogWords::next()
{
    m_rest = rest();
    const auto end = std::min(m_rest.find_first_of(logBlanks), m_rest.size());
    const std::string_view word = m_rest.substr(0, end);
    m_rest.remove_prefix(end);
    return word;
}

std::optional<std::uint32_t> numberIn(std::string_view digits, int base)
{
    std::uint32_t number = 0;
    const char *end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, number, base);
    return !digits.empty() && read.ec == std::errc() && read.ptr == end ? std::optional(number)
                                                                        : std::nullopt;
}

std::optional<std::uint8_t> lengthCode(std::string_view digit)
{
    const auto number = digit.size() == 1 ? numberIn(digit, 16) : std::nullopt;
    return number ? std::optional(
                        static_cast<std::uint8_t>(std::min<std::uint32_t>(*number, CanFrame::mostBytes)))
                  : std::nullopt;
}

std::optional<Instant> secondsIn(std::string_view text)
{
    const bool isNegative = text.starts_with('-');
    text.remove_prefix(isNegative ? 1 : 0);
    const auto point = std::min(text.find('.'), text.size());
    const std::string_view whole = text.substr(0, point);
    const std::string_view decimals = text.substr(std::min(point + 1, text.size()));
    if (whole.empty() || whole.size() > mostDigitsOfSeconds || !std::ranges::all_of(whole, isDigit) ||
        !std::ranges::all_of(decimals, isDigit))
        return std::nullopt;
    std::int64_t seconds = 0;
    std::from_chars(whole.data(), whole.data() + whole.size(), seconds);
    const Instant sum = std::chrono::seconds(seconds) + decimalsIn(decimals);
    return isNegative ? -sum : sum;
}

bool beginsWith(std::string_view text, std::string_view beginning)
{
    return text.size() >= beginning.size() &&
           std::ranges::equal(text.substr(0, beginning.size()), beginning, {}, inLowerCase, inLowerCase);
}

} // namespace codewheel
