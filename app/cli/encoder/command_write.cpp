// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/protocol_rules.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/encoder/parameter_text.h"
#include "cli/encoder/position_text.h"
#include "cli/encoder/value_lines.h"
#include "cli/encoder/write_plan_text.h"
#include "cli/project/project_of_call.h"
#include "project/project_file.h"
#include "transfer/project_places.h"
#include "transfer/value_store.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *writeExamples[] = {
    "write 1.0 steps=255 revolutions=1 direction=cw preset=0",
    "write 1.0 steps=255 revolutions=1 direction=cw preset=0 --yes --trace",
    "write 2.0 steps=4096 coding=gray-cw --dry-run",
    "write 05 steps=864 scaling=on direction=ccw --yes --trace",
};

constexpr std::array writeOptions{
    deviceOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "write without asking")},
    Option{"--dry-run", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "show what would be written, and send nothing")},
    Option{"--all", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "write also what the encoder already has")},
    Option{"--store", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "keep in the project (--project) what is known of the encoder then")},
    traceOption,
};

// The state of the encoder before the job and after it: a rod may have another scale afterwards.
struct Stand
{
    Reading reading;
    std::optional<RodScale> scale;
};

Stand standOf(const EncoderSession &encoder)
{
    return {encoder.latest(), rodScale(encoder)};
}

void takePositions(const Outcome &outcome, Stand &before, Stand &after)
{
    before.reading.position = outcome.positionBefore;
    after.reading.position = outcome.positionAfter;
}

// A rod shows its last position even in error.
bool showsPosition(const Reading &reading)
{
    return reading.state == EncoderState::operation || reading.position;
}

QString accountText(const Outcome &outcome, const Stand &before, const Stand &after)
{
    QString text = eepromWritesLine(outcome);
    if (showsPosition(before.reading))
        text += sentence(CommandLine::tr("Position before: %1"),
                         {positionText(before.reading.position, before.reading, before.scale)}) +
                u'\n';
    if (showsPosition(after.reading))
        text += sentence(CommandLine::tr("Position after:  %1"),
                         {positionText(after.reading.position, after.reading, after.scale)}) +
                u'\n';
    if (outcome.result && after.reading.state == EncoderState::error)
        text += whereItWasLeft(after.reading) + u'\n';
    return text;
}

QJsonArray writtenJson(const EncoderSession &encoder, const ParameterValues &values)
{
    QJsonArray json;
    for (const ParameterValue &value : values) {
        QJsonObject object = valueJson(*encoder.device().find(value.parameter), value.value);
        addEvidence(object, encoder.known(value.parameter));
        json.append(object);
    }
    return json;
}

void addAccount(QJsonObject &json, const EncoderSession &encoder, const Outcome &outcome, const Stand &before,
                const Stand &after)
{
    json.insert(QStringLiteral("written"), writtenJson(encoder, outcome.written));
    json.insert(QStringLiteral("alreadyThere"), writtenJson(encoder, outcome.alreadyThere));
    if (protocolRules(encoder.device().profile).storesByStep())
        json.insert(QStringLiteral("stored"), writtenJson(encoder, outcome.stored));
    if (!outcome.confirmed.empty())
        json.insert(QStringLiteral("confirmed"), valuesJson(encoder, outcome.confirmed));
    json.insert(QStringLiteral("eepromWrites"), outcome.eepromWrites);
    json.insert(QStringLiteral("positionBefore"), numberJson(before.reading.position));
    json.insert(QStringLiteral("positionAfter"), numberJson(after.reading.position));
    json.insert(QStringLiteral("leftIn"), stateKey(outcome.leftIn));
    json.insert(QStringLiteral("onlyZeroSinceRun"), outcome.onlyZeroSinceRun);
}

// That values just written do not act.
QString notInForceLine(const EncoderSession &encoder, const ParameterValues &written)
{
    const auto note = scalingNote(encoder, written);
    return note ? noteText(*note) + u'\n' : QString();
}

void carryOutWrite(const Call &call, const AllowedJob &write, const WritePlan &plan, Answer &answer)
{
    const EncoderSession &encoder = write.encoder();
    const BusAccess &bus = call.busOf(encoder.place());
    Stand before = standOf(encoder);
    const FinishedJob job = runToEnd(call, write);
    Stand after = standOf(encoder);
    if (encoder.agreesOnPositions())
        takePositions(job.outcome, before, after);
    if (endedOutOfSight(job.outcome))
        after.reading = {};
    const auto account = bus.account(encoder, plan.job.values, job);
    answer.text += u'\n';
    addTrace(call, encoder.place(), *job.trace, answer);
    answer.text += account->toText() + accountText(job.outcome, before, after) +
                   notInForceLine(encoder, job.outcome.written) + doubtLines(encoder, job.outcome.inDoubt) +
                   bus.whereItIsNow(encoder, plan.job.values);
    if (job.outcome.onlyZeroSinceRun)
        answer.text += messageText({.id = MessageId::onlyZeroSinceRun}) + u'\n';
    addAccount(answer.json, encoder, job.outcome, before, after);
    addDoubt(answer.json, encoder, job.outcome.inDoubt);
    merge(answer.json, account->toJson());
    if (!job.outcome.result) {
        answer.complaint = complaintAboutJob(call, encoder.place(), job.outcome.result.error());
        answer.complaint->text += u' ' + account->whereItWasLeft();
    }
}

// Asked before anything is written.
Checked<void> checkStore(const Call &call, const EncoderSession &encoder)
{
    if (!call.arguments.has("--store"))
        return {};
    if (call.project == nullptr)
        return badInput("storeNeedsProject",
                        CommandLine::tr("--store keeps values in a project. Name it with --project FILE."));
    const auto why = ProjectPlaces(*call.project, call.buses).hindrance(encoder.place());
    return why ? Checked<void>(tl::unexpected(complaintAbout(*why))) : Checked<void>();
}

// The next call would not know it of an encoder that cannot be read.
void store(const Call &call, const EncoderSession &encoder, Answer &answer)
{
    const QString file = *call.arguments.value("--project");
    Project project = *call.project;
    ProjectDevice &kept = *findDevice(project, encoder.place());
    kept = withStored(kept, encoder);
    const auto saved = saveUnlessChanged(project, file, projectMark(*call.project));
    if (saved)
        answer.text += sentence(CommandLine::tr("Saved in %1."), {file}) + u'\n';
    else if (!answer.complaint)
        answer.complaint = saved.error();
}

Checked<Answer> runWrite(const Call &call, EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    if (!device.capabilities.writes)
        return tl::unexpected(
            complaintAbout({RefusalKind::notSupported, RefusalId::writingNotSupported, {device.fullName()}}));
    if (const auto may = checkStore(call, encoder); !may)
        return tl::unexpected(may.error());
    const auto values = valuesToWrite(device, call.arguments.rest.sliced(1));
    if (!values)
        return tl::unexpected(values.error());
    if (const auto ready = call.busOf(encoder.place()).prepareWrite(call, encoder, *values); !ready)
        return tl::unexpected(ready.error());
    const WritePlan plan = planWrite(
        encoder, {.wanted = *values, .writeAll = call.arguments.has("--all"), .inOrderGiven = true});
    if (plan.refusal)
        return tl::unexpected(complaintAbout(*plan.refusal));

    if (!call.arguments.has("--json"))
        call.terminal.print(writePlanText(encoder, plan));
    Answer answer;
    answer.json = {{QStringLiteral("plan"), writePlanJson(encoder, plan)},
                   {QStringLiteral("notes"), valueNotesJson(plan.notes)}};
    if (call.arguments.has("--dry-run") || plan.jobs.empty())
        return answer;
    const auto allowed = eepromConsent(call, encoder, plan.job, AsksAnyway::yes);
    if (!allowed) {
        answer.complaint = allowed.error();
        return answer;
    }
    const QString question = sentence(CommandLine::tr("Write this to %1?"), {encoder.place().shown()});
    const auto agreed = consent(call, question,
                                CommandLine::tr("Nothing was sent: there is nobody to ask. Add --yes to "
                                                "write, or --dry-run to look only."));
    if (!agreed) {
        answer.complaint = agreed.error();
        return answer;
    }
    carryOutWrite(call, *allowed, plan, answer);
    if (call.arguments.has("--store"))
        store(call, encoder, answer);
    return answer;
}

} // namespace

const Subcommand writeCommand{
    .name = "write",
    .usage = "PLACE PARAMETER=VALUE... [--yes] [--dry-run] [--all] [--store] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "write parameters, after showing what and asking"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Shows what is known of the parameters, what they are to become, and the words for it; asks; writes "
        "them\n"
        "in the order given, and tells by which evidence they are there. What the encoder already has is "
        "not\n"
        "written again, unless --all is given: it is read first where that is possible, else it is what was\n"
        "written from here. Where nobody can be asked, --yes is needed: without it nothing is sent, exit "
        "code "
        "2.\n"
        "\n"
        "Parameters: steps revolutions direction coding preset zero-offset offset measuring-range; of a "
        "linear\n"
        "encoder direction measuring-length external-preset; as far as the encoder has them (devices NAME).\n"
        "A VALUE is a number or a name: 255, 0xFF, FFh, cw."),
    .examples = writeExamples,
    .options = writeOptions,
    .arguments = {2, ArgumentCount::any},
    .needsBus = true,
    .textIsAccount = true,
    .run = atPlace<runWrite>,
};

} // namespace codewheel
