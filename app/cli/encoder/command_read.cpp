// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/encoder/parameter_text.h"
#include "cli/encoder/value_lines.h"
#include "vocabulary/known_words.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *readExamples[] = {"read 1.0", "read 1.0 steps revolutions direction preset",
                                        "read 1.0 serial-number --trace",
                                        "read 1.0 temperature opc-register-3", "read 1.0 --json"};

constexpr std::array readOptions{
    deviceOption,
    traceOption,
};

// The encoder cannot be read: what is known of it from writes made here.
Answer whatIsKnown(const EncoderSession &encoder)
{
    TextTable table;
    QJsonArray known;
    for (const ParameterDescription &parameter : encoder.device().parameters) {
        const auto value = encoder.known(parameter.parameter);
        if (!value)
            continue;
        table.add({parameterKey(parameter.parameter), valueCell(parameter, value->value),
                   known_words::word(value)});
        QJsonObject json = valueJson(parameter, value->value);
        addEvidence(json, value);
        known.append(json);
    }
    Answer answer;
    answer.complaint = complaintAbout(
        {RefusalKind::notSupported, RefusalId::readingNotSupported, {encoder.device().fullName()}});
    answer.json = {{QStringLiteral("known"), known}};
    if (!encoder.device().capabilities.writes)
        return answer;
    if (known.isEmpty())
        answer.complaint->text +=
            u' ' +
            CommandLine::tr("Nothing was written to it in this call either, so nothing is known of it.");
    else
        answer.text = CommandLine::tr("Last written from here:") + u'\n' + table.toString(2);
    return answer;
}

// A value of a serial encoder that is text (manual, read command V); no other encoder has it, so it is not a
// Parameter.
const QString versionName = QStringLiteral("version");

// What was named; the version in it is read in a different way than the numbers.
struct NamedValues
{
    std::vector<Parameter> parameters;
    bool hasVersion = false;
};

Checked<NamedValues> namedValues(const DeviceDescription &device, bool tellsVersion, QStringList names)
{
    NamedValues named;
    const bool isAll = names.isEmpty();
    const auto versions = tellsVersion ? names.removeAll(versionName) : 0;
    if (versions > 1)
        return badInput("parameterGivenTwice", CommandLine::tr("\"%1\" is there twice. Give it once."),
                        {versionName});
    auto parameters = parametersToRead(device, names);
    if (!parameters)
        return tl::unexpected(parameters.error());
    named.parameters = isAll ? device.readableValues() : *std::move(parameters);
    named.hasVersion = versions == 1 || (isAll && tellsVersion);
    return named;
}

QJsonObject versionJson(const QString &version)
{
    return {{QStringLiteral("parameter"), versionName},
            {QStringLiteral("value"), textJson(version)},
            {QStringLiteral("unit"), unitKey(Unit::none)}};
}

QString versionTold(const Call &call, const EncoderSession &encoder)
{
    return call.busOf(encoder.place()).versionOf(encoder);
}

// What no job reads.
Answer versionOf(const Call &call, EncoderSession &encoder)
{
    const QString version = versionTold(call, encoder);
    Answer answer;
    answer.text = valueLines(encoder, {}, version);
    answer.json = {{QStringLiteral("values"), QJsonArray{versionJson(version)}}};
    if (version.isEmpty())
        answer.complaint =
            complaintAbout({RefusalKind::device,
                            RefusalId::escNoAnswer,
                            {encoder.place().shown() + QStringLiteral(" V"), std::int64_t{1}}});
    return answer;
}

Answer readFrom(const Call &call, EncoderSession &encoder, NamedValues named)
{
    const QString version = named.hasVersion ? versionTold(call, encoder) : QString();
    const FinishedJob job = runToEnd(call, {encoder, ReadParameters{std::move(named.parameters)}});
    Answer answer;
    QJsonArray values = valuesJson(encoder, job.outcome.read);
    if (named.hasVersion)
        values.append(versionJson(version));
    answer.json = {{QStringLiteral("values"), values}};
    addDoubt(answer.json, encoder, job.outcome.inDoubt);
    addTrace(call, encoder.place(), *job.trace, answer);
    answer.text += valueLines(encoder, job.outcome.read, version) + doubtLines(encoder, job.outcome.inDoubt);
    if (!job.outcome.result)
        answer.complaint = complaintAboutEnd(call, encoder, job.outcome);
    else
        answer.complaint = foundInParameterization(call, encoder);
    return answer;
}

Checked<Answer> runRead(const Call &call, EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    Answer answer;
    if (!device.capabilities.reads) {
        answer = whatIsKnown(encoder);
    } else {
        auto named =
            namedValues(device, call.busOf(encoder.place()).tellsVersion(), call.arguments.rest.sliced(1));
        if (!named)
            return tl::unexpected(named.error());
        answer =
            named->parameters.empty() ? versionOf(call, encoder) : readFrom(call, encoder, *std::move(named));
    }
    return answer;
}

} // namespace

const Subcommand readCommand{
    .name = "read",
    .usage = "PLACE [PARAMETER...] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "read the parameters that an encoder has"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Reads the parameters named, or all that can be read but the registers of the bus chip, which are\n"
        "read by name: opc-register-0 to opc-register-15. While it is read, the encoder shows no position.\n"
        "An encoder without read-out (devices tells which) is not asked: exit code 1.\n"
        "An encoder on a serial line also has a version, which is text."),
    .examples = readExamples,
    .options = readOptions,
    .arguments = {1, ArgumentCount::any},
    .needsBus = true,
    .run = atPlace<runRead>,
};

} // namespace codewheel
