// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_forms.h"

#include "catalog/hex_code.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_scaling.h"
#include "vocabulary/hex.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr int codeDigits = 4;      // 16 bit
constexpr int fractionDigits = 10; // significant ones of 32 bit

Word rawOf(std::int64_t value)
{
    return static_cast<Word>(value);
}

QString bitsText(esc::Command command, std::int64_t value, bool isSwapped)
{
    const auto raw = static_cast<std::uint16_t>(value);
    const QStringList bits = esc::bitTexts(command, raw);
    const QString said =
        bits.isEmpty() ? QCoreApplication::translate("EscBit", "none") : bits.join(QStringLiteral(", "));
    return QStringLiteral("%1 (%2)").arg(esc::bitDigits(isSwapped ? esc::swappedBytes(raw) : raw, isSwapped),
                                         said);
}

QString factorText(std::int64_t value, const KindData &given)
{
    const QString digits = hexWord(rawOf(value)) + u'h';
    const auto *options = given.as<EscValueOptions>();
    return options != nullptr
               ? QStringLiteral("%1 (%2)").arg(
                     digits, QLocale().toString(esc::scalingFactor(rawOf(value), options->fractionBits), 'g',
                                                fractionDigits))
               : digits;
}

std::optional<ValueForm::Range> factorRange(const KindData &given)
{
    const auto *options = given.as<EscValueOptions>();
    if (options == nullptr)
        return std::nullopt;
    const esc::ValueRange range = esc::scalingFactorRange(options->fractionBits);
    return ValueForm::Range{range.smallest, range.largest};
}

bool swapsWarnings(const KindData &given)
{
    const auto *options = given.as<EscValueOptions>();
    return options != nullptr && options->swapsWarningBytes;
}

std::optional<std::int64_t> warningsAsSent(std::int64_t value, const KindData &options)
{
    return swapsWarnings(options)
               ? std::optional<std::int64_t>(esc::swappedBytes(static_cast<std::uint16_t>(value)))
               : std::nullopt;
}

QString factorRangeText()
{
    return QStringLiteral("%1 ... %2")
        .arg(QLocale().toString(esc::smallestFactor, 'f', 5), QLocale().toString(esc::largestFactor, 'f', 1));
}

} // namespace

const ValueForm *escForm(Parameter parameter)
{
    using enum esc::Command;
    static constexpr ValueForm address{
        .text = [](std::int64_t value,
                   const KindData &) { return EscLineAddress{static_cast<std::uint8_t>(value)}.shown(); },
        .typedHexDigits = 2};
    static constexpr ValueForm serial{
        [](std::int64_t value, const KindData &) { return hexWord(rawOf(value)); }};
    static constexpr ValueForm code{
        [](std::int64_t value, const KindData &) { return hexCode(rawOf(value), codeDigits); }};
    static constexpr ValueForm factor{
        .text = factorText, .range = factorRange, .rangeText = factorRangeText, .typedHexDigits = 8};
    static constexpr ValueForm operating{
        [](std::int64_t value, const KindData &) { return bitsText(operatingParameters, value, false); }};
    static constexpr ValueForm alarmBits{
        [](std::int64_t value, const KindData &) { return bitsText(alarms, value, false); }};
    static constexpr ValueForm warningBits{
        .text = [](std::int64_t value,
                   const KindData &options) { return bitsText(warnings, value, swapsWarnings(options)); },
        .asSent = warningsAsSent};
    static constexpr std::pair<Parameter, const ValueForm *> forms[] = {
        {Parameter::lineAddress, &address},
        {Parameter::serialNumber, &serial},
        {Parameter::deviceCode, &code},
        {Parameter::scalingFactor, &factor},
        {Parameter::operatingParameters, &operating},
        {Parameter::alarms, &alarmBits},
        {Parameter::warnings, &warningBits},
    };
    const auto found = std::ranges::find(forms, parameter, &std::pair<Parameter, const ValueForm *>::first);
    return found == std::end(forms) ? nullptr : found->second;
}

} // namespace codewheel
