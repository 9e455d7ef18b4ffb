// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_words.h"

#include "catalog/value_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace codewheel::parameter_words {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("ParameterWords", text);
}

QString range(const ParameterDescription &parameter)
{
    if (parameter.choices.empty())
        return tr("Range: %1 to %2.")
            .arg(valueText(parameter, parameter.minimum), withUnit(parameter, parameter.maximum));
    QStringList choices;
    for (const Choice &choice : parameter.choices)
        choices << valueText(parameter, choice.value);
    return tr("Choices: %1.").arg(choices.join(QStringLiteral("; ")));
}

} // namespace

QString withUnit(const ParameterDescription &parameter, std::int64_t value)
{
    const QString unit = unitText(parameter.unit);
    const QString text = valueText(parameter, value);
    return unit.isEmpty() ? text : QStringLiteral("%1 %2").arg(text, unit);
}

QString list(const DeviceDescription &device, const ParameterValues &values)
{
    QStringList texts;
    for (const ParameterValue &value : values)
        if (const ParameterDescription *parameter = device.find(value.parameter))
            texts << QStringLiteral("%1 = %2").arg(parameterName(value.parameter),
                                                   valueText(*parameter, value.value));
    return texts.join(QStringLiteral(", "));
}

QString evidence(Evidence evidence)
{
    switch (evidence) {
    case Evidence::read:
        return tr("read");
    case Evidence::echoed:
        return tr("echoed");
    case Evidence::told:
        break;
    }
    return tr("told");
}

QString howKnown(const std::optional<Known> &known, const QDateTime &when)
{
    if (!known)
        return tr("Not known: nobody has read, written or told it.");
    const QString time = QLocale().toString(when, QLocale::ShortFormat);
    switch (known->evidence) {
    case Evidence::read:
        return tr("Read from the encoder, %1.").arg(time);
    case Evidence::echoed:
        return tr("Confirmed by the encoder in a handshake that ended in operation, %1.").arg(time);
    case Evidence::told:
        break;
    }
    return tr("Told by the user or by the plan of the bus, %1. The encoder was not asked.").arg(time);
}

QString rangeAndFactory(const ParameterDescription &parameter)
{
    if (!parameter.number)
        return tr("Can be read, not written.");
    const QString factory = parameter.factory
                                ? tr("Factory setting: %1.").arg(valueText(parameter, *parameter.factory))
                                : tr("The factory setting is not stated.");
    return range(parameter) + QLatin1Char('\n') + factory;
}

} // namespace codewheel::parameter_words
