// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/decimal_text.h"

#include "encoder/hex.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

constexpr double beyondEveryRange = 1e12;

struct DecimalText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DecimalText)
};

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
    QString plain = typed;
    bool isNumber = false;
    const double number = plain.replace(u',', u'.').toDouble(&isNumber);
    if (!isNumber || !qIsFinite(number))
        return tl::unexpected(DecimalText::tr("\"%1\" is not a number.").arg(typed));
    return number;
}

tl::expected<std::int64_t, QString> readWhole(const QString &text, const QLocale &locale)
{
    if (const auto number = parseNumber(text))
        return *number;
    const auto decimal = readDecimal(text, locale);
    if (!decimal)
        return tl::unexpected(decimal.error());
    if (*decimal != std::floor(*decimal))
        return tl::unexpected(hasDecimalsText(text));
    return std::llround(std::clamp(*decimal, -beyondEveryRange, beyondEveryRange));
}

QString hasDecimalsText(const QString &text)
{
    return DecimalText::tr("%1 has decimals; a whole number belongs here.").arg(text.trimmed());
}

} // namespace codewheel
