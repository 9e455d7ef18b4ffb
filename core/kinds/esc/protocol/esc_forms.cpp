// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_forms.h"

#include "catalog/hex_code.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_scaling.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/hex.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

using Options = std::optional<ValueOptions>;

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

QString factorText(std::int64_t value, const Options &options)
{
    const QString digits = hexWord(rawOf(value)) + u'h';
    return options ? QStringLiteral("%1 (%2)").arg(
                         digits, QLocale().toString(esc::scalingFactor(rawOf(value), options->fractionBits),
                                                    'g', fractionDigits))
                   : digits;
}

ValueForm::Range factorRange(const ValueOptions &options)
{
    const esc::ValueRange range = esc::scalingFactorRange(options.fractionBits);
    return {range.smallest, range.largest};
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
                   const Options &) { return EscLineAddress{static_cast<std::uint8_t>(value)}.shown(); },
        .typedHexDigits = 2};
    static constexpr ValueForm serial{
        [](std::int64_t value, const Options &) { return hexWord(rawOf(value)); }};
    static constexpr ValueForm code{
        [](std::int64_t value, const Options &) { return hexCode(rawOf(value), codeDigits); }};
    static constexpr ValueForm factor{factorText, factorRange, factorRangeText, 8};
    static constexpr ValueForm operating{
        [](std::int64_t value, const Options &) { return bitsText(operatingParameters, value, false); }};
    static constexpr ValueForm alarmBits{
        [](std::int64_t value, const Options &) { return bitsText(alarms, value, false); }};
    static constexpr ValueForm warningBits{[](std::int64_t value, const Options &options) {
        return bitsText(warnings, value, options && options->swapsWarningBytes);
    }};
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
