// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/decimal_text.h"

#include "vocabulary/hex.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace codewheel {
namespace {

constexpr QChar narrowSpace(0x202F); // between thousands, as some countries write them

struct DecimalText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DecimalText)
};

QString withoutSpaces(QString text)
{
    return text.remove(u' ').remove(QChar(QChar::Nbsp)).remove(narrowSpace);
}

// "1,000" or "12.000.000" could be grouped thousands; "0,001" and "1,25" could not.
bool mayBeGrouped(const QString &text)
{
    static const QRegularExpression grouped(QStringLiteral(R"(^[+-]?[1-9]\d{0,2}([.,]\d{3})+$)"));
    return grouped.match(text).hasMatch();
}

QString twoMeanings(const QString &text, QChar sign, const QLocale &locale)
{
    QString whole = text;
    QString parted = text;
    whole.remove(sign);
    parted.replace(sign, locale.decimalPoint());
    return DecimalText::tr("\"%1\" may mean %2 or %3. Leave the sign between thousands out, or write the "
                           "decimals with \"%4\".")
        .arg(text, whole, parted, locale.decimalPoint());
}

} // namespace

tl::expected<double, QString> readDecimal(const QString &text, const QLocale &locale)
{
    const QString typed = text.trimmed();
    const bool hasPoint = typed.contains(u'.');
    const bool hasComma = typed.contains(u',');
    const QChar sign = hasPoint ? u'.' : u',';
    if (hasPoint && hasComma)
        return tl::unexpected(
            DecimalText::tr("\"%1\" has point and comma. Write it without signs between thousands.")
                .arg(typed));
    const bool isForeign = (hasPoint || hasComma) && locale.decimalPoint() != QString(sign);
    if (isForeign && mayBeGrouped(typed))
        return tl::unexpected(twoMeanings(typed, sign, locale));
    QString plain = withoutSpaces(typed);
    bool isNumber = false;
    const double number = plain.replace(u',', u'.').toDouble(&isNumber);
    if (!isNumber || !qIsFinite(number))
        return tl::unexpected(DecimalText::tr("\"%1\" is not a number.").arg(typed));
    return number;
}

tl::expected<std::int64_t, QString> readWhole(const QString &text)
{
    QString digits = withoutSpaces(text);
    const bool isNegative = digits.startsWith(u'-');
    if (isNegative || digits.startsWith(u'+'))
        digits.remove(0, 1);
    if (const auto number = parseNumber(digits))
        return isNegative ? -*number : *number;
    const bool isMadeOfDigits =
        std::ranges::all_of(digits, [](QChar c) { return c.isDigit() || c == u'.' || c == u','; });
    if (isMadeOfDigits && (text.contains(u'.') || text.contains(u',')))
        return tl::unexpected(DecimalText::tr("\"%1\" is not a whole number. Digits only, for example 1000.")
                                  .arg(text.trimmed()));
    return tl::unexpected(DecimalText::tr("\"%1\" is not a number.").arg(text.trimmed()));
}

} // namespace codewheel
