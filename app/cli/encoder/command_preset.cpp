// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_rules.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/encoder/position_text.h"
#include "cli/encoder/told_mode.h"
#include "cli/encoder/value_lines.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *presetExamples[] = {"preset 1.0", "preset 1.0 1000", "preset 1.0 3E8h --trace",
                                          "preset 1.0 1000 --fraba"};

constexpr std::array presetOptions{
    Option{
        "--fraba", nullptr,
        QT_TRANSLATE_NOOP("codewheel::CommandLine", "send the FRABA preset, which works as often as wanted")},
    inPositionModeOption,
    deviceOption,
    budgetYesOption,
    beyondLimitOption,
    ledgerOption,
    traceOption,
};

Checked<SetPreset> presetJob(const Call &call, const DeviceDescription &device)
{
    SetPreset job;
    if (call.arguments.has("--fraba"))
        job.command = PresetCommand::manufacturer;
    if (call.arguments.rest.size() < 2)
        return job;
    // An LA-66 has no preset as a parameter: the value is the position itself.
    ParameterDescription anyPosition;
    anyPosition.parameter = Parameter::preset;
    anyPosition.maximum = protocolRules(device.profile).largestData();
    anyPosition.unit = Unit::steps;
    const ParameterDescription *preset = device.find(Parameter::preset);
    if (!preset && device.capabilities.presetNeedsValue)
        preset = &anyPosition;
    if (!preset)
        return tl::unexpected(
            complaintAbout({RefusalKind::notSupported, RefusalId::presetNotSupported, {device.fullName()}}));
    const auto value = numberFrom(*preset, call.arguments.rest[1]);
    if (!value)
        return tl::unexpected(value.error());
    job.value = *value;
    return job;
}

// It was sent, and its effect was looked for.
bool isAboutPreset(RefusalCode why)
{
    return why == RefusalId::presetNotTaken || why == RefusalId::presetUsedUp ||
           why == RefusalId::presetNotKnown || why == RefusalId::presetNotKnownWithout;
}

// Without a mode that was told and did not hold.
Reading shownBefore(Reading before, const EncoderSession &encoder)
{
    if (!encoder.latest().mode)
        before.mode.reset();
    return before;
}

// Everything if it was done, otherwise as far as something is known.
QString whatIsKnown(const FinishedJob &job, const Reading &before, const EncoderSession &encoder)
{
    const Outcome &outcome = job.outcome;
    const bool isSent = outcome.result || isAboutPreset(outcome.result.error().id);
    const auto line = [&](const QString &pattern, const std::optional<std::int64_t> &position,
                          const Reading &shown) {
        return isSent || position
                   ? sentence(pattern, {positionText(position, shown, rodScale(encoder))}) + u'\n'
                   : QString();
    };
    const bool isFateUntold = job.lastStep.setsPosition && !outcome.inDoubt.position;
    return line(CommandLine::tr("Position before: %1"), outcome.positionBefore,
                shownBefore(before, encoder)) +
           line(CommandLine::tr("Position after:  %1"), outcome.positionAfter, encoder.latest()) +
           (isSent || mayHaveWritten(outcome) ? eepromWritesLine(outcome) : QString()) +
           doubtLines(encoder, outcome.inDoubt) +
           (isSent || outcome.written.empty()
                ? QString()
                : CommandLine::tr("Written:") + u'\n' + valueLines(encoder, outcome.written)) +
           (isSent || !isFateUntold || outcome.positionAfter
                ? QString()
                : CommandLine::tr("Whether the position was set is not known: read it.") + u'\n');
}

Checked<Answer> runPreset(const Call &call, EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    const auto preset = presetJob(call, device);
    if (!preset)
        return tl::unexpected(preset.error());

    (void)tellMode(encoder, call.arguments);
    const auto allowed = eepromConsent(call, encoder, *preset, AsksAnyway::no);
    if (!allowed)
        return tl::unexpected(allowed.error());
    const Reading before = encoder.latest();
    const FinishedJob job = runToEnd(call, *allowed);
    Answer answer;
    answer.json = {{QStringLiteral("positionBefore"), numberJson(job.outcome.positionBefore)},
                   {QStringLiteral("positionAfter"), numberJson(job.outcome.positionAfter)},
                   {QStringLiteral("written"), valuesJson(encoder, job.outcome.written)},
                   {QStringLiteral("eepromWrites"), job.outcome.eepromWrites}};
    addDoubt(answer.json, encoder, job.outcome.inDoubt);
    addTrace(call, encoder.place(), *job.trace, answer);
    answer.text += whatIsKnown(job, before, encoder);
    if (!job.outcome.result) {
        answer.complaint = withHowToTellMode(complaintAboutEnd(call, encoder, job.outcome));
        return answer;
    }
    if (job.outcome.leftIn == EncoderState::error)
        answer.text += whereItWasLeft(encoder.latest()) + u'\n';
    return answer;
}

} // namespace

const Subcommand presetCommand{
    .name = "preset",
    .usage = "PLACE [VALUE] [--fraba] [--in-position-mode] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "set the position of an encoder"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Makes the encoder show its preset value at the place where its shaft stands. With a VALUE, that is\n"
        "written as the preset first. Sends at once, without asking.\n"
        "\n"
        "A FRABA encoder activates a preset once; it is programmed again where that is needed. The FRABA "
        "preset\n"
        "(60000000, for one bus cycle) needs no programming again."),
    .examples = presetExamples,
    .options = presetOptions,
    .arguments = {1, 2},
    .needsBus = true,
    .textIsAccount = true,
    .run = atPlace<runPreset>,
};

} // namespace codewheel
