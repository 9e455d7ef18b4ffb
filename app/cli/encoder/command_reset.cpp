// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_bus.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/position_text.h"
#include "cli/encoder/value_lines.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *resetExamples[] = {"reset 1.0", "reset 2.0 --yes --trace"};

constexpr std::array resetOptions{
    deviceOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "reset without asking")},
    traceOption,
};

// Other kinds of bus have no words.
bool hasWords(const Call &call, const EncoderSession &encoder)
{
    return call.busOf(encoder.place()).bus().channel(encoder.place()) != nullptr;
}

// What is lost, and what it costs.
QString warningText(const EncoderSession &encoder, bool byWords)
{
    QStringList lost;
    for (const ParameterDescription &parameter : encoder.device().parameters)
        if (parameter.canBeWritten)
            lost << parameterKey(parameter.parameter);
    QString text =
        sentence(byWords ? CommandLine::tr("%1, %2, will be reset to factory settings (0E000000, then run).")
                         : CommandLine::tr("%1, %2, will be reset to factory settings."),
                 {encoder.place().shown(), encoder.device().fullName()}) +
        u'\n' + sentence(CommandLine::tr("This is lost: %1."), {lost.join(QStringLiteral(", "))}) + u'\n';
    if (encoder.can().cams && !byWords)
        text += CommandLine::tr("All cam programs are lost, too.") + u'\n';
    else if (encoder.can().cams)
        text += CommandLine::tr("All cam programs are lost, too, and the encoder is in position mode "
                                "afterwards.") +
                u'\n';
    return text + sentence(CommandLine::tr("EEPROM writes:   %1"), {QStringLiteral("1")}) +
           costOfLeaving(encoder) + u'\n';
}

// How far a reset got, by the steps that were begun.
struct ResetSteps
{
    bool isSent = false;     // 0E000000
    bool hasRun = false;     // run was sent behind it
    bool isAnswered = false; // and was answered

    void begun(const Progress &progress)
    {
        const auto index = static_cast<std::size_t>(progress.index);
        if (index >= progress.steps.size())
            return;
        const Step &step = progress.steps[index];
        isAnswered = isAnswered || hasRun;
        hasRun = hasRun || (isSent && step.effect == Effect::activates);
        isSent = isSent || (step.effect == Effect::takes && step.parameters.empty());
    }
};

// Where the job failed, beside what is in doubt.
QString whatWasSent(const ResetSteps &steps, const FinishedJob &job)
{
    if (!steps.isSent && !job.lastStep.steps.empty())
        return CommandLine::tr("The reset itself, 0E000000, was not sent.") + u'\n';
    if (steps.isAnswered)
        return CommandLine::tr("0E000000 and run were sent and answered; what the encoder has now was not "
                               "read back.") +
               u'\n';
    return {};
}

// Read back if possible, otherwise the factory settings, by the confirmation.
ParameterValues valuesNow(const EncoderSession &encoder)
{
    ParameterValues values;
    for (const ParameterDescription &parameter : encoder.device().parameters)
        if (const auto known = encoder.known(parameter.parameter); known && parameter.canBeWritten)
            values.push_back({parameter.parameter, known->value});
    return values;
}

void carryOutReset(const Call &call, const AllowedJob &reset, Answer &answer)
{
    const EncoderSession &encoder = reset.encoder();
    ResetSteps steps;
    QObject scope;
    QObject::connect(&encoder, &EncoderSession::progressed, &scope,
                     [&](const Progress &progress) { steps.begun(progress); });
    const FinishedJob job = runToEnd(call, reset);
    const DeviceDescription &device = encoder.device();
    answer.text += u'\n';
    addTrace(call, encoder.place(), *job.trace, answer);
    answer.json.insert(QStringLiteral("eepromWrites"), job.outcome.eepromWrites);
    answer.json.insert(QStringLiteral("leftIn"), stateKey(job.outcome.leftIn));
    addDoubt(answer.json, encoder, job.outcome.inDoubt);
    if (!job.outcome.result) {
        answer.text += eepromWritesLine(job.outcome) + doubtLines(encoder, job.outcome.inDoubt) +
                       (hasWords(call, encoder) ? whatWasSent(steps, job) : QString());
        answer.complaint = complaintAboutEnd(call, encoder, job.outcome);
        if (job.outcome.resetWaits)
            answer.complaint->text += u' ' + messageText({.id = MessageId::resetWaitsForRun});
        return;
    }
    const ParameterValues values = valuesNow(encoder);
    answer.json.insert(QStringLiteral("values"), valuesJson(encoder, values));
    answer.json.insert(QStringLiteral("position"), numberJson(encoder.latest().position));
    answer.json.insert(QStringLiteral("onlyZeroSinceRun"), job.outcome.onlyZeroSinceRun);
    answer.text +=
        (device.capabilities.reads ? CommandLine::tr("Read back:")
                                   : CommandLine::tr("Factory settings, confirmed by the handshake:")) +
        u'\n' + valueLines(encoder, values) + eepromWritesLine(job.outcome) +
        sentence(CommandLine::tr("Position after:  %1"),
                 {positionText(encoder.latest().position, encoder.latest())}) +
        u'\n';
    if (job.outcome.onlyZeroSinceRun)
        answer.text += messageText({.id = MessageId::onlyZeroSinceRun}) + u'\n';
}

Checked<Answer> runReset(const Call &call, EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    if (!encoder.can().resets)
        return tl::unexpected(
            complaintAbout({RefusalKind::notSupported, RefusalId::resetNotSupported, {device.fullName()}}));
    if (!call.arguments.has("--json"))
        call.terminal.print(warningText(encoder, hasWords(call, encoder)));
    Answer answer;
    const auto allowed = eepromConsent(call, encoder, ResetToDefault{}, AsksAnyway::yes);
    if (!allowed) {
        answer.complaint = allowed.error();
        return answer;
    }
    const auto agreed =
        consent(call, sentence(CommandLine::tr("Reset %1?"), {encoder.place().shown()}),
                CommandLine::tr("Nothing was sent: there is nobody to ask. Add --yes to reset."));
    if (agreed)
        carryOutReset(call, *allowed, answer);
    else
        answer.complaint = agreed.error();
    return answer;
}

} // namespace

const Subcommand resetCommand{
    .name = "reset",
    .usage = "PLACE [--yes] [--trace]",
    .summary =
        QT_TRANSLATE_NOOP("codewheel::CommandLine", "reset an encoder to factory settings, after asking"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Tells what is lost and what it costs; asks; resets the encoder; and tells what it has then, read "
        "back\n"
        "where that is possible. Where nobody can be asked, --yes is needed: without it nothing is sent, "
        "exit\n"
        "code 2."),
    .examples = resetExamples,
    .options = resetOptions,
    .arguments = {1},
    .needsBus = true,
    .textIsAccount = true,
    .run = atPlace<runReset>,
};

} // namespace codewheel
