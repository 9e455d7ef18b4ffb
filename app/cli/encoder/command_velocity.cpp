// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/position_text.h"
#include "cli/encoder/told_mode.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *velocityExamples[] = {"velocity 1.0 on", "velocity 1.0 off --trace",
                                            "velocity 1.0 on --in-position-mode"};

constexpr std::array velocityOptions{
    deviceOption, inPositionModeOption, budgetYesOption, beyondLimitOption, ledgerOption, traceOption,
};

Checked<SwitchMode> modeJob(const QString &wanted)
{
    if (wanted == QStringLiteral("on"))
        return SwitchMode{Mode::velocity};
    if (wanted == QStringLiteral("off"))
        return SwitchMode{Mode::position};
    return badInput("onOrOff", CommandLine::tr("\"%1\" is neither on nor off."), {wanted});
}

QString readingText(const Reading &reading)
{
    if (reading.velocity)
        return sentence(CommandLine::tr("Velocity mode: %1 rpm"), {argumentText(*reading.velocity)}) + u'\n';
    if (reading.mode == Mode::velocity)
        return sentence(CommandLine::tr("Velocity mode: IN %1 shows no speed"), {hexWord(reading.in)}) +
               u'\n';
    return sentence(CommandLine::tr("Position mode: %1"), {positionText(reading.position, reading)}) + u'\n';
}

// What was only told is no answer of the encoder, nor is what it was in before its link was lost.
std::optional<Mode> modeProven(const Outcome &outcome, const Reading &reading, bool isTold)
{
    const bool isAsBefore = isTold && reading.mode == Mode::position;
    return !outcome.result && (isAsBefore || endedOutOfSight(outcome)) ? std::nullopt : reading.mode;
}

Checked<Answer> runVelocity(const Call &call, EncoderSession &encoder)
{
    const auto wanted = modeJob(call.arguments.rest[1]);
    if (!wanted)
        return tl::unexpected(wanted.error());

    const bool isTold = tellMode(encoder, call.arguments);
    const auto allowed = eepromConsent(call, encoder, *wanted, AsksAnyway::no);
    if (!allowed)
        return tl::unexpected(allowed.error());
    const FinishedJob job = runToEnd(call, *allowed);
    const Reading &reading = encoder.latest();
    Answer answer;
    answer.json = {{QStringLiteral("eepromWrites"), job.outcome.eepromWrites},
                   {QStringLiteral("mode"), modeJson(modeProven(job.outcome, reading, isTold))},
                   {QStringLiteral("velocity"), numberJson(reading.velocity)},
                   {QStringLiteral("position"), numberJson(reading.position)}};
    addDoubt(answer.json, encoder, job.outcome.inDoubt);
    addTrace(call, encoder.place(), *job.trace, answer);
    if (job.outcome.result)
        answer.text += readingText(reading);
    if (mayHaveWritten(job.outcome))
        answer.text += eepromWritesLine(job.outcome);
    answer.text += doubtLines(encoder, job.outcome.inDoubt);
    if (!job.outcome.result)
        answer.complaint = withHowToTellMode(complaintAboutEnd(call, encoder, job.outcome));
    return answer;
}

} // namespace

const Subcommand velocityCommand{
    .name = "velocity",
    .usage = "PLACE on|off [--in-position-mode] [--trace]",
    .summary =
        QT_TRANSLATE_NOOP("codewheel::CommandLine", "let an encoder show its speed, or its position again"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "In velocity mode an encoder shows whole revolutions per minute instead of its position, and goes on "
        "so\n"
        "after power-off, until it is switched off. Sends at once, without asking; writes nothing to the "
        "EEPROM,\n"
        "but \"off\" ends cam mode, too: a cam program that was changed is stored when it is left."),
    .examples = velocityExamples,
    .options = velocityOptions,
    .arguments = {2},
    .needsBus = true,
    .textIsAccount = true,
    .run = atPlace<runVelocity>,
};

} // namespace codewheel
