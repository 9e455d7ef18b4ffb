// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parameter_text.h"

#include "catalog/hex_code.h"
#include "catalog/value_text.h"
#include "cli/texts.h"
#include "encoder/hex.h"
#include "esc/esc_bits.h"

namespace codewheel {

namespace {

// Of a serial encoder what is no number is told as its hexadecimal digits, and bits by name too.
QString escText(const ParameterDescription &parameter, std::int64_t value)
{
    if (!parameter.readCommand || parameter.readBit)
        return {};
    using enum esc::Command;
    const auto raw = static_cast<Word>(value);
    switch (*parameter.readCommand) {
    case serialNumber:
        return hexWord(raw);
    case scalingFactor:
        return hexWord(raw) + u'h';
    case deviceCode:
        return hexCode(raw, 4);
    case operatingParameters:
    case alarms:
    case warnings: {
        const QStringList bits = esc::bitTexts(*parameter.readCommand, static_cast<std::uint16_t>(value));
        const QString said = bits.isEmpty() ? CommandLine::tr("none") : bits.join(QStringLiteral(", "));
        return QStringLiteral("%1 (%2)").arg(hexCode(raw, 4), said);
    }
    default:
        return {};
    }
}

} // namespace

QString typedValue(const ParameterDescription &parameter, std::int64_t value)
{
    if (const QString text = escText(parameter, value); !text.isEmpty())
        return text;
    const Choice *choice = parameter.findChoice(value);
    return choice && choice->key != QString::number(value)
               ? QStringLiteral("%1 (%2)").arg(choice->key).arg(value)
               : valueText(parameter, value);
}

QString rangeText(const ParameterDescription &parameter)
{
    if (parameter.choices.empty() && parameter.unit == Unit::micrometres) // shown as millimetres
        return QStringLiteral("%1..%2").arg(valueText(parameter, parameter.minimum),
                                            valueText(parameter, parameter.maximum));
    if (parameter.choices.empty())
        return QStringLiteral("%1..%2").arg(parameter.minimum).arg(parameter.maximum);
    QStringList texts;
    for (const Choice &choice : parameter.choices)
        texts << typedValue(parameter, choice.value);
    return texts.join(QStringLiteral(", "));
}

QString evidenceText(Evidence evidence)
{
    switch (evidence) {
    case Evidence::read:
        return CommandLine::tr("read from the encoder");
    case Evidence::echoed:
        return CommandLine::tr("confirmed by the handshake");
    case Evidence::told:
        break;
    }
    return CommandLine::tr("told, not checked");
}

} // namespace codewheel
