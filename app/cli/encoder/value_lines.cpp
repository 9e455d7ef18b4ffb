// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/value_lines.h"

#include "catalog/value_text.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/encoder/parameter_text.h"
#include "vocabulary/known_words.h"

namespace codewheel {

QString valueCell(const ParameterDescription &parameter, const Value &value, const KindData &options)
{
    const bool isItsUnit = parameterKey(parameter.parameter) == unitKey(parameter.unit);
    const QString unit =
        isItsUnit || unitText(parameter, value).isEmpty() ? QString() : unitText(parameter.unit);
    return QStringLiteral("= %1 %2").arg(typedValue(parameter, value, options), unit).trimmed();
}

QString valueLines(const EncoderSession &encoder, const ParameterValues &values, const QString &version)
{
    TextTable table;
    for (const ParameterValue &value : values) {
        const ParameterDescription &parameter = *encoder.device().find(value.parameter);
        QStringList cells{parameterKey(value.parameter),
                          valueCell(parameter, value.value, valueOptionsOf(&encoder))};
        if (const auto known = encoder.known(value.parameter))
            cells << known_words::word(known->kept);
        table.add(cells);
    }
    if (!version.isEmpty())
        table.add({QStringLiteral("version"), QStringLiteral("= %1").arg(version)});
    return table.toString();
}

QJsonArray valuesJson(const EncoderSession &encoder, const ParameterValues &values)
{
    const auto options = valueOptionsOf(&encoder);
    QJsonArray json;
    for (const ParameterValue &value : values) {
        const ParameterDescription &parameter = *encoder.device().find(value.parameter);
        QJsonObject object = valueJson(parameter, value.value);
        if (parameter.form != nullptr && parameter.form->asSent != nullptr)
            if (const auto sent = parameter.form->asSent(value.value.number(), options))
                object.insert(QStringLiteral("asSent"), static_cast<qint64>(*sent));
        addKept(object, encoder.known(value.parameter));
        json.append(object);
    }
    return json;
}

} // namespace codewheel
