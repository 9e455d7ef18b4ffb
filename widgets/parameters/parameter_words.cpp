// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_words.h"

#include "catalog/value_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace codewheel::parameter_words {

namespace {

// The context of these texts.
struct ParameterWords
{
    Q_DECLARE_TR_FUNCTIONS(ParameterWords)
};

QString range(const ParameterDescription &parameter)
{
    if (parameter.isText())
        return ParameterWords::tr("Range: %1.").arg(textLimit(parameter));
    if (parameter.choices.empty())
        return ParameterWords::tr("Range: %1 to %2.")
            .arg(valueText(parameter, parameter.minimum), valueText(parameter, parameter.maximum));
    QStringList choices;
    for (const Choice &choice : parameter.choices)
        choices << valueText(parameter, choice.value);
    return ParameterWords::tr("Choices: %1.").arg(choices.join(QStringLiteral("; ")));
}

} // namespace

QString rangeAndFactory(const ParameterDescription &parameter)
{
    if (parameter.onLabel)
        return ParameterWords::tr("Printed on the label of the encoder; it is set manually, never written.") +
               QLatin1Char('\n') + range(parameter);
    if (!parameter.canBeWritten)
        return ParameterWords::tr("Can be read, not written.");
    const QString factory =
        parameter.factory
            ? ParameterWords::tr("Factory setting: %1.").arg(valueText(parameter, *parameter.factory))
            : ParameterWords::tr("The factory setting is not stated.");
    return range(parameter) + QLatin1Char('\n') + factory;
}

} // namespace codewheel::parameter_words
