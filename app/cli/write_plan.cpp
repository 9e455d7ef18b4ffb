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
#include "esc/esc_request.h"

#include <algorithm>

namespace codewheel {
namespace {

QString sentBy(const Step &step)
{
    return step.kind == StepKind::request ? QString::fromLatin1(step.line) : hexWord(step.out);
}

QString sentFor(Parameter parameter, const std::vector<Step> &steps)
{
    const auto step = std::ranges::find_if(
        steps, [parameter](const Step &one) { return writesValue(one) && one.parameter == parameter; });
    return sentBy(*step); // each value has its step
}

QString knownText(const WritePlan::Row &row)
{
    return row.known ? typedValue(*row.parameter, row.known->value) : CommandLine::tr("unknown");
}

} // namespace

WritePlan::WritePlan(const EncoderSession &encoder, bool all)
    : m_encoder(encoder)
    , m_readsFirst(encoder.can().reads && !all && !isOnLine()) // where it was read before
    , m_stepsMinusOneIsOpen(false)
{}

Checked<WritePlan> WritePlan::make(const EncoderSession &encoder, const ParameterValues &wanted, bool all,
                                   const EscSettings &escSettings)
{
    const DeviceDescription &device = encoder.device();
    const auto stepsFor = [&](const ParameterValues &values) {
        return plannedSteps(device, allKnown(encoder), WriteParameters{.values = values, .previous = {}}, {},
                            k3::normalRunning, escSettings);
    };
    const auto steps = stepsFor(wanted);
    if (!steps)
        return tl::unexpected(complaintAbout(steps.error()));

    WritePlan plan(encoder, all);
    for (const auto &[parameter, value] : wanted) {
        const auto known = encoder.known(parameter);
        const bool isThere = known && known->value == value && known->evidence != Evidence::told;
        plan.m_rows.push_back({.parameter = device.find(parameter),
                               .wanted = value,
                               .known = known,
                               .sent = sentFor(parameter, *steps),
                               .leftOut = isThere && !all});
    }
    const ParameterValues differing = plan.job().values;
    for (Row &row : plan.m_rows)
        row.leftOut = row.leftOut && !mustGoAlong(device, row.parameter->parameter, differing);
    plan.m_stepsMinusOneIsOpen = device.quirks.mayCountStepsMinusOne && valueOf(wanted, Parameter::steps) &&
                                 !encoder.known(Parameter::multiTurnAndStepsMinusOne);
    if (plan.isEmpty() || !plan.isOnLine())
        return plan;
    const auto left = stepsFor(plan.job().values);
    if (!left)
        return tl::unexpected(complaintAbout(left.error()));
    plan.addWhatGoesAlong(*left, wanted);
    return plan;
}

WriteParameters WritePlan::job() const
{
    WriteParameters job;
    job.onlyWhatDiffers = m_readsFirst;
    for (const Row &row : m_rows)
        if (!row.leftOut && !row.goesAlong)
            job.values.push_back({row.parameter->parameter, row.wanted});
    return job;
}

QString WritePlan::toText() const
{
    TextTable table;
    table.add({CommandLine::tr("parameter"), CommandLine::tr("known"), CommandLine::tr("wanted"),
               isOnLine() ? CommandLine::tr("command") : QStringLiteral("OUT")});
    for (const Row &row : m_rows)
        table.add({parameterKey(row.parameter->parameter), knownText(row),
                   typedValue(*row.parameter, row.wanted),
                   row.leftOut ? CommandLine::tr("left out: already there") : row.sent});
    if (!isEmpty() && !isRod() && !isOnLine())
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
    if (std::ranges::any_of(m_rows, &Row::goesAlong))
        text +=
            CommandLine::tr("The scaling factor is computed from them: they act once it is sent.") + u'\n';
    for (const ValueNote &note : valueNotes())
        text += noteText(note) + u'\n';
    if (isOnLine())
        text += CommandLine::tr("Each command is sent once, and what was written is read back.") + u'\n';
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

// The factor of a serial encoder, where steps or measuring range are written; and all in the order in which
// it is sent.
void WritePlan::addWhatGoesAlong(const std::vector<Step> &steps, const ParameterValues &wanted)
{
    for (const Step &step : steps) {
        const auto request = esc::parseRequest(step.line);
        if (!request || !writesValue(step) || !step.parameter || valueOf(wanted, *step.parameter))
            continue;
        m_rows.push_back({.parameter = m_encoder.device().find(*step.parameter),
                          .wanted = request->data,
                          .known = m_encoder.known(*step.parameter),
                          .sent = sentBy(step),
                          .goesAlong = true});
    }
    const auto turnOf = [&](const Row &row) {
        return std::ranges::find_if(steps, [&](const Step &step) { return sentBy(step) == row.sent; });
    };
    std::ranges::stable_sort(m_rows, {}, turnOf);
}

std::vector<ValueNote> WritePlan::valueNotes() const
{
    return codewheel::valueNotes(m_encoder.device(), job().values, valuesOf(allKnown(m_encoder)));
}

QJsonArray WritePlan::notesJson() const
{
    QJsonArray json;
    for (const ValueNote &note : valueNotes())
        json.append(QJsonObject{{QStringLiteral("key"), noteKey(note.id)},
                                {QStringLiteral("arguments"), argumentsJson(note.arguments)}});
    return json;
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
        object.insert(isOnLine() ? QStringLiteral("command") : QStringLiteral("word"), row.sent);
        object.insert(QStringLiteral("leftOut"), row.leftOut);
        json.append(object);
    }
    return json;
}

} // namespace codewheel
