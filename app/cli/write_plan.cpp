// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/write_plan.h"

#include "catalog/device_description.h"
#include "cli/json.h"
#include "cli/parameter_text.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "drivers/planned_words.h"
#include "drivers/values_to_write.h"
#include "encoder/hex.h"
#include "encoder/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

Word wordFor(Parameter parameter, const std::vector<Step> &steps)
{
    const auto step = std::ranges::find_if(
        steps, [parameter](const Step &one) { return writesValue(one) && one.parameter == parameter; });
    return step->out; // each value has its step
}

QString knownText(const WritePlan::Row &row)
{
    return row.known ? typedValue(*row.parameter, row.known->value) : CommandLine::tr("unknown");
}

} // namespace

WritePlan::WritePlan(const EncoderSession &encoder, bool all)
    : m_encoder(encoder)
    , m_readsFirst(encoder.can().reads && !all)
    , m_stepsMinusOneIsOpen(false)
{}

Checked<WritePlan> WritePlan::make(const EncoderSession &encoder, const ParameterValues &wanted, bool all)
{
    const DeviceDescription &device = encoder.device();
    const auto steps =
        plannedSteps(device, allKnown(encoder), WriteParameters{.values = wanted, .previous = {}});
    if (!steps)
        return tl::unexpected(complaintAbout(steps.error()));

    WritePlan plan(encoder, all);
    for (const auto &[parameter, value] : wanted) {
        const auto known = encoder.known(parameter);
        const bool isThere = known && known->value == value && known->evidence != Evidence::told;
        plan.m_rows.push_back({.parameter = device.find(parameter),
                               .wanted = value,
                               .known = known,
                               .word = wordFor(parameter, *steps),
                               .leftOut = isThere && !all});
    }
    plan.m_stepsMinusOneIsOpen = device.quirks.mayCountStepsMinusOne && valueOf(wanted, Parameter::steps) &&
                                 !encoder.known(Parameter::multiTurnAndStepsMinusOne);
    return plan;
}

WriteParameters WritePlan::job() const
{
    WriteParameters job;
    job.onlyWhatDiffers = m_readsFirst;
    for (const Row &row : m_rows)
        if (!row.leftOut)
            job.values.push_back({row.parameter->parameter, row.wanted});
    return job;
}

QString WritePlan::toText() const
{
    TextTable table;
    table.add({CommandLine::tr("parameter"), CommandLine::tr("known"), CommandLine::tr("wanted"),
               QStringLiteral("OUT")});
    for (const Row &row : m_rows)
        table.add({parameterKey(row.parameter->parameter), knownText(row),
                   typedValue(*row.parameter, row.wanted),
                   row.leftOut ? CommandLine::tr("left out: already there") : hexWord(row.word)});
    if (!isEmpty() && !isRod())
        table.add({CommandLine::tr("run"), {}, {}, hexWord(k3::run)});
    return sentence(CommandLine::tr("To be written to %1, %2:"),
                    {m_encoder.number().toString(), m_encoder.device().fullName()}) +
           u'\n' + table.toString(2) + notes();
}

QString WritePlan::notes() const
{
    QString text;
    if (isEmpty())
        return CommandLine::tr("The encoder has all of it: there is nothing to write.") + u'\n';
    if (m_readsFirst)
        text += CommandLine::tr("The encoder is read first, and what it already has is left out.") + u'\n';
    if (isRod())
        text +=
            CommandLine::tr("Each word goes out for two bus cycles with its first bit, the service bit, 0; "
                            "what was written is read back.") +
            u'\n';
    if (m_stepsMinusOneIsOpen)
        text +=
            CommandLine::tr("If it turns out to count steps minus 1, the word of steps carries one less.") +
            u'\n';
    return text;
}

// Services need no run.
bool WritePlan::isRod() const
{
    return m_encoder.device().profile == Profile::la66;
}

QJsonArray WritePlan::toJson() const
{
    QJsonArray json;
    for (const Row &row : m_rows) {
        QJsonObject object = valueJson(*row.parameter, row.wanted);
        object.insert(QStringLiteral("known"), row.known ? numberJson(row.known->value) : QJsonValue());
        object.insert(QStringLiteral("evidence"),
                      row.known ? QJsonValue(evidenceKey(row.known->evidence)) : QJsonValue());
        object.insert(QStringLiteral("word"), wordJson(row.word));
        object.insert(QStringLiteral("leftOut"), row.leftOut);
        json.append(object);
    }
    return json;
}

} // namespace codewheel
