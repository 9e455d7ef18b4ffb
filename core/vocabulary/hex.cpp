// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/hex.h"

#include <algorithm>

namespace codewheel {
namespace {

// The most digits that fit into 64 bits whatever they are.
constexpr qsizetype longestDecimal = 18;
constexpr qsizetype longestHexadecimal = 15;
constexpr qsizetype digitsOfWord = 8;

constexpr QStringView plcMark = u"16#";

struct HexText
{
    QStringView digits;
    bool marked = false; // "0x.." or "..h"
};

// After a prefix the suffix counts as a digit, so "0x20h" is refused.
HexText withoutHexMark(QStringView text)
{
    if (text.startsWith(u"0x", Qt::CaseInsensitive))
        return {text.sliced(2), true};
    if (text.startsWith(plcMark))
        return {text.sliced(plcMark.size()), true};
    if (text.endsWith(u'h', Qt::CaseInsensitive))
        return {text.chopped(1), true};
    return {text, false};
}

// -1 for anything but a digit. QChar::digitValue() would also accept the digits of other scripts.
int digitValue(QChar c)
{
    const char16_t u = c.unicode();
    if (u >= u'0' && u <= u'9')
        return u - u'0';
    if (u >= u'A' && u <= u'F')
        return u - u'A' + 10;
    if (u >= u'a' && u <= u'f')
        return u - u'a' + 10;
    return -1;
}

std::optional<std::int64_t> digitsToNumber(QStringView digits, int base, qsizetype longest)
{
    if (digits.isEmpty() || digits.size() > longest)
        return std::nullopt;
    std::int64_t number = 0;
    for (const QChar c : digits) {
        const int digit = digitValue(c);
        if (digit < 0 || digit >= base)
            return std::nullopt;
        number = number * base + digit;
    }
    return number;
}

// "16#0200 16#00FF"
std::optional<Word> plcWords(QStringView text)
{
    const auto second = text.lastIndexOf(plcMark);
    if (second <= 0 || !text.startsWith(plcMark))
        return std::nullopt;
    const auto high =
        digitsToNumber(text.sliced(plcMark.size(), second - plcMark.size()).trimmed(), 16, digitsOfWord / 2);
    const auto low = digitsToNumber(text.sliced(second + plcMark.size()), 16, digitsOfWord / 2);
    return high && low ? std::optional(static_cast<Word>(*high << 16 | *low)) : std::nullopt;
}

} // namespace

QString hexNumber(std::uint32_t number, int digits)
{
    return QStringLiteral("%1").arg(number, digits, 16, QLatin1Char('0')).toUpper() + u'h';
}

QString hexWord(Word word)
{
    return QStringLiteral("%1").arg(word, digitsOfWord, 16, QLatin1Char('0')).toUpper();
}

std::optional<Word> parseHexWord(QStringView text)
{
    const QStringView plain = text.trimmed();
    if (const auto words = plcWords(plain))
        return words;
    QString digits = withoutHexMark(plain).digits.toString();
    const bool isPlc = plain.startsWith(plcMark);
    digits.removeIf([isPlc](QChar c) { return c.isSpace() || (isPlc && c == u'_'); });
    const auto number = digitsToNumber(digits, 16, digitsOfWord);
    return number ? std::optional(static_cast<Word>(*number)) : std::nullopt;
}

std::optional<std::int64_t> parseHexDigits(QStringView digits, qsizetype longest)
{
    return digitsToNumber(digits, 16, std::min(longest, longestHexadecimal));
}

std::optional<std::int64_t> parseNumber(QStringView text)
{
    const HexText hex = withoutHexMark(text.trimmed());
    return hex.marked ? digitsToNumber(hex.digits, 16, longestHexadecimal)
                      : digitsToNumber(hex.digits, 10, longestDecimal);
}

} // namespace codewheel
