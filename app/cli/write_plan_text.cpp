// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/write_plan_text.h"

#include "catalog/device_description.h"
#include "cli/json.h"
#include "cli/parameter_text.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/hex.h"
#include "encoder/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

QString notesText(const EncoderSession &encoder, const WritePlan &plan)
{
    QStringList lines;
    if (plan.rows.empty())
        return CommandLine::tr("The encoder has all of it: there is nothing to write.") + u'\n';
    if (plan.job.onlyWhatDiffers)
        lines << CommandLine::tr("The encoder is read first, and what it already has is left out.");
    if (std::ranges::any_of(plan.rows, &WritePlan::Row::goesAlong))
        lines << CommandLine::tr("The scaling factor is computed from them: they act once it is sent.");
    for (const ValueNote &note : plan.notes)
        lines << noteText(note);
    if (encoder.device().outWords == 0)
        lines << CommandLine::tr("Each command is sent once, and what was written is read back.");
    if (encoder.device().profile == Profile::la66)
        lines << CommandLine::tr("Each word goes out for two bus cycles with its first bit, the service bit, "
                                 "0; what was written is read back.");
    if (plan.stepsMayBeLess)
        lines << CommandLine::tr("If it turns out to count steps minus 1, the word of steps carries one "
                                 "less.");
    return lines.isEmpty() ? QString() : lines.join(u'\n') + u'\n';
}

} // namespace

QString writePlanText(const EncoderSession &encoder, const WritePlan &plan)
{
    const DeviceDescription &device = encoder.device();
    const bool hasWords = device.outWords > 0;
    TextTable table;
    table.add({CommandLine::tr("parameter"), CommandLine::tr("known"), CommandLine::tr("wanted"),
               hasWords ? QStringLiteral("OUT") : CommandLine::tr("command")});
    const auto add = [&](const ParameterValue &value, const std::optional<Known> &known,
                         const QString &sent) {
        const ParameterDescription &parameter = *device.find(value.parameter);
        table.add({parameterKey(value.parameter),
                   known ? typedValue(parameter, known->value) : CommandLine::tr("unknown"),
                   typedValue(parameter, value.value), sent});
    };
    for (const WritePlan::Row &row : plan.rows)
        add(row.value, row.known, sentText(row.step));
    for (const ParameterValue &value : plan.leftOut)
        add(value, encoder.known(value.parameter), CommandLine::tr("left out: already there"));
    const bool endsWithRun = hasWords && device.profile != Profile::la66; // services need none
    if (!plan.rows.empty() && endsWithRun)
        table.add({CommandLine::tr("run"), {}, {}, hexWord(k3::run)});
    return sentence(CommandLine::tr("To be written to %1, %2:"),
                    {encoder.place().shown(), device.fullName()}) +
           u'\n' + table.toString(2) + notesText(encoder, plan);
}

QJsonArray writePlanJson(const EncoderSession &encoder, const WritePlan &plan)
{
    const QString carrier =
        encoder.device().outWords > 0 ? QStringLiteral("word") : QStringLiteral("command");
    QJsonArray json;
    const auto add = [&](const ParameterValue &value, const std::optional<Known> &known,
                         const QJsonValue &sent) {
        QJsonObject object = valueJson(*encoder.device().find(value.parameter), value.value);
        addKnown(object, known);
        object.insert(carrier, sent);
        object.insert(QStringLiteral("leftOut"), sent.isNull());
        json.append(object);
    };
    for (const WritePlan::Row &row : plan.rows)
        add(row.value, row.known, sentText(row.step));
    for (const ParameterValue &value : plan.leftOut)
        add(value, encoder.known(value.parameter), {});
    return json;
}

QJsonArray valueNotesJson(const std::vector<ValueNote> &notes)
{
    QJsonArray json;
    for (const ValueNote &note : notes)
        json.append(QJsonObject{{QStringLiteral("key"), noteKey(note.id)},
                                {QStringLiteral("arguments"), argumentsJson(note.arguments)}});
    return json;
}

} // namespace codewheel
