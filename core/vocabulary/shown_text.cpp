// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/shown_text.h"

#include <algorithm>

namespace codewheel {
namespace {

bool isBetween(char16_t c, char16_t first, char16_t last)
{
    return c >= first && c <= last;
}

bool isControl(char16_t c)
{
    constexpr char16_t space = 0x20;
    return c < space || isBetween(c, 0x7F, 0x9F);
}

bool turnsDirection(char16_t c)
{
    constexpr char16_t arabicLetterMark = 0x061C;
    return c == arabicLetterMark || isBetween(c, 0x200E, 0x200F) || isBetween(c, 0x202A, 0x202E) ||
           isBetween(c, 0x2066, 0x2069);
}

bool steers(char16_t c)
{
    constexpr char16_t byteOrderMark = 0xFEFF;
    return isControl(c) || turnsDirection(c) || isBetween(c, 0x2028, 0x2029) || c == byteOrderMark ||
           QChar::isSurrogate(c);
}

bool isPair(QStringView text)
{
    return text.size() > 1 && text[0].isHighSurrogate() && text[1].isLowSurrogate();
}

QString escaped(QStringView text, bool escapesBreaks)
{
    QString result;
    result.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char16_t c = text[i].unicode();
        const bool isBreak = c == u'\n' || c == u'\t';
        if (isPair(text.sliced(i)))
            result += text.sliced(i++, 2);
        else if (steers(c) && (escapesBreaks || !isBreak))
            result += u"\\u"_qs + QString::number(c, 16).rightJustified(4, u'0').toUpper();
        else
            result += text[i];
    }
    return result;
}

bool isHarmless(const QString &text)
{
    return std::ranges::none_of(text, [](QChar c) { return steers(c.unicode()); });
}

} // namespace

QString shownText(const QString &text)
{
    return isHarmless(text) ? text : escaped(text, false);
}

QString shownInLine(const QString &text)
{
    return isHarmless(text) ? text : escaped(text, true);
}

} // namespace codewheel
