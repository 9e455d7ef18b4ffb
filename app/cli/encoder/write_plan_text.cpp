// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/write_plan_text.h"

#include "catalog/protocol_rules.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/parameter_text.h"
#include "jobs/protocol.h"
#include "jobs/step_text.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

QString notesText(const EncoderSession &encoder, const WritePlan &plan)
{
    if (plan.jobs.empty())
        return CommandLine::tr("The encoder has all of it: there is nothing to write.") + u'\n';
    QStringList lines = howItIsWritten(plan);
    if (std::ranges::any_of(plan.rows,
                            [](const WriteRow &row) { return row.goesAlong && !row.isInStepOfOthers(); }))
        lines << CommandLine::tr("The scaling factor is computed from them, and sent after them.");
    for (const ValueNote &note : plan.notes)
        lines << noteText(note);
    if (const QString how = protocolOf(encoder.device()).howItIsSent(); !how.isEmpty())
        lines << how;
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
    for (const WriteRow &row : plan.rows) {
        const ParameterDescription &parameter = *device.find(row.wanted.parameter);
        table.add({parameterKey(row.wanted.parameter),
                   row.known ? typedValue(parameter, row.known->value) : CommandLine::tr("unknown"),
                   typedValue(parameter, row.wanted.value),
                   row.step ? sentText(*row.step) : CommandLine::tr("left out: already there")});
    }
    const auto run = std::ranges::find(plan.steps, Effect::activates, &Step::effect);
    if (!plan.jobs.empty() && run != plan.steps.end())
        table.add({CommandLine::tr("run"), {}, {}, sentText(*run)});
    return sentence(CommandLine::tr("To be written to %1, %2:"),
                    {encoder.place().shown(), device.fullName()}) +
           u'\n' + table.toString(2) + notesText(encoder, plan);
}

QJsonArray writePlanJson(const EncoderSession &encoder, const WritePlan &plan)
{
    const QString carrier =
        encoder.device().outWords > 0 ? QStringLiteral("word") : QStringLiteral("command");
    QJsonArray json;
    for (const WriteRow &row : plan.rows) {
        QJsonObject object = valueJson(*encoder.device().find(row.wanted.parameter), row.wanted.value);
        addKnown(object, row.known);
        object.insert(carrier, row.step ? QJsonValue(sentText(*row.step)) : QJsonValue());
        object.insert(QStringLiteral("leftOut"), !row.step);
        if (row.isInStepOfOthers())
            object.insert(QStringLiteral("goesAlong"), true);
        json.append(object);
    }
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
