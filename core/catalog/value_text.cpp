// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/value_text.h"

#include "catalog/hex_code.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <tuple>

namespace codewheel {
namespace {

struct ChoiceRow
{
    const char *key;
    const char *name;
};

constexpr ChoiceRow choiceNames[] = {
    {"cw", QT_TRANSLATE_NOOP("Choice", "CW")},
    {"ccw", QT_TRANSLATE_NOOP("Choice", "CCW")},
    {"signed-cw", QT_TRANSLATE_NOOP("Choice", "signed, CW")},
    {"signed-ccw", QT_TRANSLATE_NOOP("Choice", "signed, CCW")},
    {"unsigned-cw", QT_TRANSLATE_NOOP("Choice", "unsigned, CW")},
    {"unsigned-ccw", QT_TRANSLATE_NOOP("Choice", "unsigned, CCW")},
    {"gray-cw", QT_TRANSLATE_NOOP("Choice", "Gray, CW")},
    {"gray-ccw", QT_TRANSLATE_NOOP("Choice", "Gray, CCW")},
    {"activated", QT_TRANSLATE_NOOP("Choice", "preset activated")},
    {"programmed", QT_TRANSLATE_NOOP("Choice", "preset programmed, not activated")},
    {"k2", QT_TRANSLATE_NOOP("Choice", "position, as K2")},
    {"k3", QT_TRANSLATE_NOOP("Choice", "position, as K3")},
    {"velocity", QT_TRANSLATE_NOOP("Choice", "velocity")},
    {"single-turn", QT_TRANSLATE_NOOP("Choice", "single-turn")},
    {"single-turn-minus-1", QT_TRANSLATE_NOOP("Choice", "single-turn, steps minus 1")},
    {"multi-turn", QT_TRANSLATE_NOOP("Choice", "multi-turn")},
    {"increasing", QT_TRANSLATE_NOOP("Choice", "increasing")},
    {"decreasing", QT_TRANSLATE_NOOP("Choice", "decreasing")},
    {"no-error", QT_TRANSLATE_NOOP("Choice", "no error")},
    {"magnet-outside", QT_TRANSLATE_NOOP("Choice", "magnet outside the measuring range")},
    {"on", QT_TRANSLATE_NOOP("Choice", "on")},
    {"off", QT_TRANSLATE_NOOP("Choice", "off")},
    {"multi-turn-minus-1", QT_TRANSLATE_NOOP("Choice", "multi-turn, steps minus 1")},
};

// "cam-1" .. "cam-8"
QString camProgramName(QStringView key)
{
    return QCoreApplication::translate("Choice", "cam program %1").arg(key.sliced(4));
}

// How many wire units make one displayed unit.
double divisorOf(Unit unit)
{
    switch (unit) {
    case Unit::tenMinutes:
        return 6;
    case Unit::tenthDegreeCelsius:
    case Unit::tenthHours:
        return 10;
    case Unit::micrometres:
        return 1000;
    case Unit::none:
    case Unit::steps:
    case Unit::revolutions:
    case Unit::milliseconds:
        break;
    }
    return 1;
}

} // namespace

ParameterDescription withOptions(ParameterDescription parameter, const KindData &options)
{
    if (parameter.form != nullptr && parameter.form->range != nullptr)
        if (const auto range = parameter.form->range(options))
            std::tie(parameter.minimum, parameter.maximum) = *range;
    return parameter;
}

QString choiceName(const ParameterDescription &parameter, const Value &value)
{
    const Choice *choice = parameter.findChoice(value);
    if (!choice)
        return {};
    if (const ChoiceRow *row = rowByKey(choiceNames, choice->key))
        return QCoreApplication::translate("Choice", row->name);
    return choice->key.startsWith(QStringLiteral("cam-")) ? camProgramName(choice->key) : choice->key;
}

namespace {

QString numberText(const ParameterDescription &parameter, std::int64_t value, const KindData &options)
{
    if (parameter.parameter == Parameter::serialNumber)
        return serialNumberText(value);
    if (parameter.hexDigits > 0)
        return hexWord(static_cast<Word>(value)).right(parameter.hexDigits) + u'h';
    if (parameter.form != nullptr)
        return parameter.form->text(value, options);
    const double divisor = divisorOf(parameter.unit);
    const int decimals = parameter.unit == Unit::micrometres ? 3 : 1;
    QString number = divisor > 1 ? QLocale().toString(static_cast<double>(value) / divisor, 'f', decimals)
                                 : QLocale().toString(qlonglong{value});
    const QString name = choiceName(parameter, value);
    if (name == QString::number(value)) // a baud rate has no name other than its number
        return number;
    return name.isEmpty() ? number : QStringLiteral("%1 (%2)").arg(number, name);
}

} // namespace

QString valueText(const ParameterDescription &parameter, const Value &value, const KindData &options)
{
    return value.isText() ? plainText(value) : numberText(parameter, value.number(), options);
}

QString textLimit(const ParameterDescription &parameter)
{
    return QCoreApplication::translate("Value", "a text of at most %1 characters").arg(parameter.textLength);
}

QString unitText(Unit unit, const std::optional<Value> &of)
{
    const bool isOne = of == 1;
    switch (unit) {
    case Unit::none:
        break;
    case Unit::steps:
        return isOne ? QCoreApplication::translate("Unit", "step")
                     : QCoreApplication::translate("Unit", "steps");
    case Unit::revolutions:
        return isOne ? QCoreApplication::translate("Unit", "revolution")
                     : QCoreApplication::translate("Unit", "revolutions");
    case Unit::tenMinutes:
    case Unit::tenthHours:
        return QCoreApplication::translate("Unit", "h");
    case Unit::tenthDegreeCelsius:
        return QCoreApplication::translate("Unit", "°C");
    case Unit::micrometres:
        return QCoreApplication::translate("Unit", "mm");
    case Unit::milliseconds:
        return QCoreApplication::translate("Unit", "ms");
    }
    return {};
}

QString unitText(const ParameterDescription &parameter, const Value &value)
{
    const auto isInWords = parameter.form != nullptr ? parameter.form->isInWords : nullptr;
    return isInWords != nullptr && isInWords(value.number()) ? QString() : unitText(parameter.unit, value);
}

} // namespace codewheel
