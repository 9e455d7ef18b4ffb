// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "catalog/catalog.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/mode_left.h"
#include "cli/encoder/parameter_text.h"
#include "cli/project/project_of_call.h"
#include "cli/project/transfer_call.h"
#include "cli/project/transfer_text.h"
#include "project/project_file.h"
#include "transfer/project_places.h"
#include "transfer/value_store.h"
#include "vocabulary/known_words.h"
#include "vocabulary/sentence.h"
#include "vocabulary/value_json.h"

#include <algorithm>
#include <array>
#include <map>

namespace codewheel {
namespace {

constexpr const char *storeExamples[] = {"store crane.codewheel", "store crane.codewheel 1.0 --cams"};

constexpr std::array storeOptions{
    Option{"--cams", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "read the cam programs as well")},
    budgetYesOption,
    beyondLimitOption,
    ledgerOption,
    traceOption,
};

struct Meant
{
    std::vector<ProjectDevice> encoders{};                   // that are where the project has them
    std::vector<std::pair<ProjectDevice, Refusal>> others{}; // that are not
};

Meant sorted(const Call &call, const Project &project, const std::vector<ProjectDevice> &devices)
{
    Meant meant;
    const ProjectPlaces places(project, call.buses);
    for (const ProjectDevice &device : devices) {
        const Place place = device.place();
        const bool isEncoder = call.catalog.find(device.participant.deviceKey) ||
                               call.catalog.generic(device.participant.deviceCode);
        if (const auto why = places.hindrance(place); why && isEncoder)
            meant.others.emplace_back(device, *why);
        else if (!why && call.buses.encoder(place) != nullptr)
            meant.encoders.push_back(device);
    }
    return meant;
}

std::vector<EncoderJobs> jobsFor(const Call &call, const std::vector<ProjectDevice> &devices)
{
    std::vector<EncoderJobs> all;
    for (const ProjectDevice &device : devices) {
        EncoderJobs jobs = jobsToStore(*call.buses.encoder(device.place()), call.arguments.has("--cams"));
        if (!jobs.jobs.empty())
            all.push_back(std::move(jobs));
    }
    return all;
}

// What the project had of it, and nobody has read or confirmed now, says so.
QString howItIsKnown(const EncoderSession &encoder, const StoredValue &stored)
{
    const QString evidence = known_words::word(stored.evidence);
    return encoder.known(stored.parameter) ? evidence
                                           : sentence(CommandLine::tr("%1, kept from before"), {evidence});
}

// To its EEPROM, by all jobs.
struct Cost
{
    int writes = 0;
    int perhaps = 0;
};

Cost costOf(const EncoderResult &result)
{
    Cost cost;
    for (const Outcome &outcome : result.outcomes) {
        cost.writes += outcome.eepromWrites;
        cost.perhaps += outcome.inDoubt.eepromWrites;
    }
    return cost;
}

QJsonObject storedJson(const EncoderSession &encoder, const ProjectDevice &device,
                       const std::vector<EncoderResult> &results)
{
    QJsonArray values;
    for (const StoredValue &stored : device.stored)
        values.append(QJsonObject{{QStringLiteral("parameter"), parameterKey(stored.parameter)},
                                  {QStringLiteral("value"), valueToJson(stored.value)},
                                  {QStringLiteral("evidence"), evidenceKey(stored.evidence)},
                                  {QStringLiteral("kept"), !encoder.known(stored.parameter)},
                                  {QStringLiteral("at"), stored.at.toString(Qt::ISODate)}});
    QJsonObject json{{QStringLiteral("stored"), values},
                     {QStringLiteral("camPrograms"), static_cast<int>(device.storedCams.size())}};
    const auto result = std::ranges::find(results, device.place(), &EncoderResult::place);
    if (result == results.end() || result->outcomes.empty())
        return json;
    InDoubt doubt = result->outcomes.back().inDoubt;
    doubt.eepromWrites = costOf(*result).perhaps;
    addDoubt(json, encoder, doubt);
    json.insert(QStringLiteral("eepromWrites"), costOf(*result).writes);
    return json;
}

void showStored(const EncoderSession &encoder, const ProjectDevice &device, Answer &answer)
{
    TextTable table;
    for (const StoredValue &stored : device.stored)
        table.add(
            {parameterKey(stored.parameter),
             QStringLiteral("= %1").arg(typedValue(&encoder.device(), {stored.parameter, stored.value})),
             howItIsKnown(encoder, stored)});
    answer.text +=
        device.place().shown() + QStringLiteral("  ") + encoder.device().fullName() + u'\n' +
        (device.stored.empty() ? QStringLiteral("  ") + CommandLine::tr("Nothing is known of it.") + u'\n'
                               : table.toString(2));
}

// Those that a signal kept from being read to the end.
void leaveOut(Meant &meant, const std::vector<EncoderResult> &results)
{
    for (const EncoderResult &result : results) {
        if (result.isBegun() && !result.why)
            continue;
        const auto left = std::ranges::find(meant.encoders, result.place, &ProjectDevice::place);
        meant.others.emplace_back(*left, Refusal{RefusalKind::stopped, RefusalId::cancelled, {}});
        meant.encoders.erase(left);
    }
}

using ModesBefore = std::map<Place, LeftMode>;

ModesBefore modesOf(const Call &call, const std::vector<ProjectDevice> &devices)
{
    ModesBefore modes;
    for (const ProjectDevice &device : devices)
        modes[device.place()] = modeShown(*call.buses.encoder(device.place()));
    return modes;
}

// Only reading cams changes the mode. Where that failed the complaint says in which it was left.
bool isInAnotherMode(const EncoderResult &result, const ModeLeft &left)
{
    return result.outcomes.size() > 1 && !left.hasFailed && left.isAnother;
}

// What reading has left behind: what the last word of a job that was cut may still do, what it cost, the
// mode.
void showWhatIsLeft(const Call &call, const std::vector<EncoderResult> &results, const ModesBefore &before,
                    Answer &answer)
{
    for (const EncoderResult &result : results) {
        if (result.outcomes.empty())
            continue;
        const EncoderSession &encoder = *call.buses.encoder(result.place);
        QString lines;
        for (const Outcome &outcome : result.outcomes)
            lines += doubtLines(encoder, outcome.inDoubt);
        if (const auto [writes, perhaps] = costOf(result); writes + perhaps > 0)
            lines += eepromWritesLine(writes, perhaps);
        const LeftMode was = before.at(result.place);
        if (const auto left = modeLeft(encoder, result.outcomes.back(), was, was);
            isInAnotherMode(result, left))
            lines += left.toText() + u'\n';
        for (const QString &one : lines.split(u'\n', Qt::SkipEmptyParts))
            answer.text += result.place.shown() + QStringLiteral(": ") + one + u'\n';
    }
}

// With the state and the mode it was left in, if its job ended without success.
Complaint complaintAboutResult(const Call &call, const EncoderResult &result)
{
    const bool isOfJob = !result.outcomes.empty() && !result.outcomes.back().result;
    Complaint complaint =
        isOfJob ? complaintAboutEnd(call, *call.buses.encoder(result.place), result.outcomes.back())
                : complaintAboutJob(call, result.place, *result.why);
    complaint.text.prepend(result.place.shown() + QStringLiteral(": "));
    return complaint;
}

// Nothing is stored of them: what is there now may be a different one.
void showOthers(const Call &call, const Meant &meant, Answer &answer)
{
    QJsonArray json;
    for (const auto &[device, why] : meant.others) {
        answer.text += sentence(CommandLine::tr("%1: nothing was stored."), {device.place().shown()}) + u'\n';
        json.append(placeJson(call, device.place(), {{QStringLiteral("why"), refusalJson(why)}}));
    }
    answer.json.insert(QStringLiteral("notStored"), json);
}

// What could not be read keeps what was known of it.
void complain(const Call &call, const std::vector<EncoderResult> &results, const Meant &meant, Answer &answer)
{
    const auto failed =
        std::ranges::find_if(results, [](const EncoderResult &result) { return result.why.has_value(); });
    if (failed != results.end())
        answer.complaint = complaintAboutResult(call, *failed);
    else if (!meant.others.empty())
        answer.complaint = complaintAbout(meant.others.front().second);
    for (const ProjectDevice &device : meant.encoders)
        if (!answer.complaint)
            answer.complaint = foundInParameterization(call, *call.buses.encoder(device.place()));
}

Checked<Answer> runStore(const Call &call)
{
    const QString &file = call.arguments.rest.front();
    const auto devices = devicesMeant(call, *call.named, file);
    if (!devices)
        return tl::unexpected(devices.error());
    Meant meant = sorted(call, *call.named, *devices);
    const auto allowed = eepromConsent(call, jobsFor(call, meant.encoders), AsksAnyway::no);
    if (!allowed)
        return tl::unexpected(allowed.error());
    const ModesBefore before = modesOf(call, meant.encoders);
    const FinishedRound round = runToEnd(call, *allowed, JobRound::AfterRefusal::goOn);
    if (round.wasCancelled)
        leaveOut(meant, round.results);
    Answer answer;
    QJsonArray encoders;
    addTrace(call, round, answer);
    Project project = *call.named;
    for (const ProjectDevice &device : meant.encoders) {
        const EncoderSession &encoder = *call.buses.encoder(device.place());
        ProjectDevice &kept = *findDevice(project, device.place());
        kept = withStored(kept, encoder);
        showStored(encoder, kept, answer);
        encoders.append(placeJson(call, kept.place(), storedJson(encoder, kept, round.results)));
    }
    answer.json.insert(QStringLiteral("encoders"), encoders);
    showWhatIsLeft(call, round.results, before, answer);
    showOthers(call, meant, answer);
    complain(call, round.results, meant, answer);
    if (meant.encoders.empty())
        return answer;
    if (const auto saved = saveUnlessChanged(project, file, projectMark(*call.named)); !saved)
        answer.complaint = saved.error();
    else
        answer.text += sentence(CommandLine::tr("Saved in %1."), {file}) + u'\n';
    return answer;
}

} // namespace

const Subcommand storeCommand{
    .name = "store",
    .usage = "PROJECT [PLACE...] [--cams] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "store in a project what encoders have"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Reads all that can be read of the encoders named, or of all, and keeps it in the project, with its\n"
        "evidence and time. While one on INTERBUS is read, it shows no position. Of an encoder that cannot "
        "be\n"
        "read what is known is kept; what nobody knows stays unknown. With --cams each cam program is read\n"
        "in the cam mode of its own; leaving one that was changed before costs an EEPROM write.\n"
        "Nothing is stored of a place where another encoder may stand than the project has (see\n"
        "\"compare\"): exit code 1. The file that was there is kept as PROJECT~."),
    .examples = storeExamples,
    .options = storeOptions,
    .arguments = {1, ArgumentCount::any},
    .needsBus = true,
    .namesProject = true,
    .textIsAccount = true,
    .run = runStore,
};

} // namespace codewheel
