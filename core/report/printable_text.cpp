// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/printable_text.h"

#include <QList>

namespace codewheel {
namespace {

bool turnsText(char32_t c)
{
    return (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

bool isPrintable(char32_t c)
{
    constexpr char32_t firstAfterControls = 0x20;
    constexpr char32_t del = 0x7F;
    constexpr char32_t lastOfC1 = 0x9F;
    if (c == U'\n' || c == U'\t')
        return true;
    if (c < firstAfterControls || (c >= del && c <= lastOfC1) || turnsText(c))
        return false;
    const bool isNoCharacter = (c & 0xFFFE) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
    return !isNoCharacter;
}

} // namespace

QString printableText(const QString &text)
{
    QString result;
    result.reserve(text.size());
    for (const char32_t c : text.toUcs4()) { // half a surrogate pair has become U+FFFD by now
        if (c == U'\r')
            continue;
        result += isPrintable(c) ? QString::fromUcs4(&c, 1) : QString(QChar::ReplacementCharacter);
    }
    return result;
}

} // namespace codewheel
