// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_format.h"

#include "vocabulary/hex.h"
#include "vocabulary/number_code.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel {

namespace {

constexpr int bitsOfNibble = 4;
constexpr qsizetype digitsOfWord = 8;

Word lowBits(Word word, int bits)
{
    return bits >= 32 ? word : word & ((Word{1} << bits) - 1);
}

QString plainNumber(qint64 number)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(number);
}

bool isHexText(QStringView text)
{
    return std::all_of(text.begin(), text.end(), [](QChar c) {
        return c.isSpace() || (c >= u'0' && c <= u'9') || (c.toUpper() >= u'A' && c.toUpper() <= u'F');
    });
}

} // namespace

QString decimalText(Word word, int bits)
{
    return plainNumber(lowBits(word, bits));
}

QString signedText(Word word, int bits)
{
    return plainNumber(signedNumber(lowBits(word, bits), bits));
}

QString grayText(Word word, int bits)
{
    return plainNumber(binaryFromGray(lowBits(word, bits)));
}

QString binaryText(Word word, int bits)
{
    QString text;
    for (int bit = bits - 1; bit >= 0; --bit) {
        text += (word >> bit & 1) != 0 ? QLatin1Char('1') : QLatin1Char('0');
        if (bit % bitsOfNibble == 0 && bit > 0)
            text += QLatin1Char(' ');
    }
    return text;
}

QString copiedText(Word word, int bits, WordNotation notation)
{
    QString digits = hexWord(word).last(bits / bitsOfNibble);
    const qsizetype half = digitsOfWord / 2;
    const bool isDouble = digits.size() > half;
    switch (notation) {
    case WordNotation::plc:
        return isDouble ? QStringLiteral("16#%1_%2").arg(digits.first(half), digits.last(half))
                        : QStringLiteral("16#") + digits;
    case WordNotation::plcWords:
        return isDouble ? QStringLiteral("16#%1 16#%2").arg(digits.first(half), digits.last(half))
                        : QStringLiteral("16#") + digits;
    case WordNotation::decimal:
        return QString::number(lowBits(word, bits));
    case WordNotation::binary:
        return QStringLiteral("2#") + binaryText(word, bits).replace(QLatin1Char(' '), QLatin1Char('_'));
    case WordNotation::hexadecimal:
        break;
    }
    return digits;
}

QString hexProblem(const QString &text)
{
    if (parseHexWord(text))
        return {};
    const QString plain = text.trimmed();
    if (plain.isEmpty())
        return QCoreApplication::translate("WordFormat", "There is no word here. Type up to 8 hexadecimal "
                                                         "digits, such as 020000FF.");
    QString digits = plain;
    digits.removeIf([](QChar c) { return c.isSpace(); });
    if (isHexText(plain) && digits.size() > digitsOfWord)
        return QCoreApplication::translate("WordFormat",
                                           "\"%1\" has %n digits, and a word has 8. Type up to 8 "
                                           "hexadecimal digits, such as 020000FF.",
                                           nullptr, static_cast<int>(digits.size()))
            .arg(plain);
    return QCoreApplication::translate("WordFormat", "\"%1\" is not a hexadecimal word. Type up to 8 of the "
                                                     "digits 0 to 9 and A to F, such as 020000FF.")
        .arg(plain);
}

} // namespace codewheel
