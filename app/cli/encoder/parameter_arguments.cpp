// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/parameter_arguments.h"

#include "catalog/catalog.h"
#include "cli/call/texts.h"
#include "cli/encoder/parameter_text.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <functional>

namespace codewheel {
namespace {

using Condition = std::function<bool(const ParameterDescription &)>;

QString namesOf(const DeviceDescription &device, const Condition &condition)
{
    QStringList names;
    for (const ParameterDescription &parameter : device.parameters)
        if (condition(parameter))
            names << parameterKey(parameter.parameter);
    return names.join(QStringLiteral(", "));
}

// Says that the device lacks it, and what it has.
tl::unexpected<Complaint> lacking(const DeviceDescription &device, const Refusal &why,
                                  const Condition &condition)
{
    Complaint complaint = complaintAbout(why);
    complaint.text += u' ' + sentence(CommandLine::tr("It has: %1."), {namesOf(device, condition)});
    return tl::unexpected(std::move(complaint));
}

Checked<const ParameterDescription *> parameterNamed(const DeviceDescription &device, const QString &name,
                                                     const Condition &condition)
{
    const auto parameter = parameterFromKey(name);
    if (!parameter)
        return badInput("unknownParameter", CommandLine::tr("There is no parameter \"%1\". The %2 has: %3."),
                        {name, device.fullName(), namesOf(device, condition)});
    const ParameterDescription *description = device.find(*parameter);
    if (!description)
        return lacking(
            device,
            {RefusalKind::badInput, RefusalId::parameterNotSupported, {*parameter, device.fullName()}},
            condition);
    if (description->onLabel)
        return badInput("parameterOnLabel",
                        CommandLine::tr("%1 is only on the label of the %2: it is neither read nor written "
                                        "over the bus. There are: %3."),
                        {*parameter, device.fullName(), namesOf(device, condition)});
    if (!condition(*description)) // can only be read
        return lacking(device,
                       {RefusalKind::badInput, RefusalId::parameterReadOnly, {*parameter, device.fullName()}},
                       condition);
    return description;
}

tl::unexpected<Complaint> notAllowed(const ParameterDescription &parameter, const QString &text)
{
    Complaint complaint = complaintAbout({RefusalKind::badInput,
                                          RefusalId::valueNotAllowed,
                                          {parameter.parameter, text, rangeText(parameter)}});
    if (parameter.choices.empty())
        complaint.text += u' ' + CommandLine::tr("Hexadecimal numbers are written 0xFF or FFh.");
    return tl::unexpected(std::move(complaint));
}

tl::unexpected<Complaint> givenTwice(Parameter parameter)
{
    return tl::unexpected(
        complaintAbout({RefusalKind::badInput, RefusalId::parameterGivenTwice, {parameter}}));
}

} // namespace

Checked<Value> valueFrom(const ParameterDescription &parameter, const QString &text)
{
    if (parameter.isText())
        return Value(text);
    return numberFrom(parameter, text).map([](std::int64_t number) { return Value(number); });
}

Checked<std::int64_t> numberFrom(const ParameterDescription &parameter, const QString &text)
{
    if (const Choice *choice = parameter.findChoice(QStringView(text)))
        return choice->value;
    const bool isBelowZero = parameter.minimum < 0 && text.startsWith(u'-');
    const auto magnitude = parseNumber(QStringView(text).sliced(isBelowZero ? 1 : 0));
    const auto number = magnitude && isBelowZero ? std::optional(-*magnitude) : magnitude;
    const bool isChoice = parameter.choices.empty() || (number && parameter.findChoice(*number));
    if (number && isChoice)
        return *number;
    return notAllowed(parameter, text);
}

Checked<Word> wordFrom(const QString &text)
{
    if (const auto word = parseHexWord(text))
        return *word;
    return badInput(
        "notAWord",
        CommandLine::tr("\"%1\" is not a word. Give up to 8 hexadecimal digits, such as 020000FF."), {text});
}

Checked<std::vector<Parameter>> parametersToRead(const DeviceDescription &device, const QStringList &names)
{
    std::vector<Parameter> parameters;
    for (const QString &name : names) {
        const auto parameter = parameterNamed(device, name, &ParameterDescription::canBeRead);
        if (!parameter)
            return tl::unexpected(parameter.error());
        if (std::ranges::count(parameters, (*parameter)->parameter) > 0)
            return givenTwice((*parameter)->parameter);
        parameters.push_back((*parameter)->parameter);
    }
    return parameters;
}

Checked<ParameterValues> valuesToWrite(const DeviceDescription &device, const QStringList &assignments)
{
    ParameterValues values;
    for (const QString &assignment : assignments) {
        const qsizetype equals = assignment.indexOf(u'=');
        if (equals < 0)
            return badInput("notAnAssignment",
                            CommandLine::tr("\"%1\" is not PARAMETER=VALUE. Write for example steps=255."),
                            {assignment});
        const auto parameter =
            parameterNamed(device, assignment.first(equals), &ParameterDescription::canBeWritten);
        if (!parameter)
            return tl::unexpected(parameter.error());
        const auto value = valueFrom(**parameter, assignment.sliced(equals + 1));
        if (!value)
            return tl::unexpected(value.error());
        if (findValue(values, (*parameter)->parameter))
            return givenTwice((*parameter)->parameter);
        values.push_back({(*parameter)->parameter, *value});
    }
    return values;
}

Checked<const DeviceDescription *> deviceNamed(const Catalog &catalog, const QString &key)
{
    if (const DeviceDescription *device = catalog.find(key))
        return device;
    return badInput("unknownDeviceName",
                    CommandLine::tr("There is no device named \"%1\". The names are: %2."),
                    {key, listed(catalog.devices(), &DeviceDescription::key)});
}

} // namespace codewheel
