// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project/transfer_call.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/stop_signals.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/told_mode.h"
#include "cli/project/project_of_call.h"
#include "cli/project/transfer_text.h"
#include "project/file_access.h"
#include "report/html_report.h"
#include "report/transfer_report.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace codewheel {
namespace {

void passTime(const Call &call, Place place)
{
    if (BusAccess *bus = call.findBus(place.bus))
        bus->advance(bus->lookInterval());
}

bool isGone(const BusAccess &bus)
{
    const BusState state = bus.bus().state();
    return state == BusState::closed || state == BusState::lost;
}

// False: it was cancelled.
bool readBefore(const Call &call, const TransferWish &wish)
{
    EncoderBus *bus = call.buses.busOf(wish.place);
    EncoderSession *encoder = bus ? bus->encoder(wish.place) : nullptr;
    if (encoder == nullptr || wish.hindrance || isGone(call.busOf(wish.place)))
        return true;
    const auto read = call.busOf(wish.place).readBefore(call, *encoder, wish.values);
    return read || read.error().key != aboutCancelling().key;
}

// Those that have modes, as the user says: none reports its own.
void tellModes(const Call &call, const std::vector<TransferWish> &wishes)
{
    for (const TransferWish &wish : wishes)
        if (EncoderSession *encoder = call.buses.encoder(wish.place);
            encoder != nullptr && encoder->device().quirks.hasModes && tellMode(*encoder, call.arguments))
            passTime(call, wish.place); // until it shows it
}

// From before the first job to after the last one, the buses of a round may write.
class WritingBuses
{
public:
    WritingBuses(const Call &call, const std::vector<EncoderJobs> &encoders)
    {
        for (const EncoderJobs &one : encoders) {
            BusAccess *bus = call.findBus(one.place.bus);
            if (bus == nullptr)
                continue;
            for (const Job &job : one.jobs) {
                bus->prepare(job);
                if (const EncoderSession *encoder = call.buses.encoder(one.place))
                    bus->listenBefore(*encoder, job);
            }
            m_buses.insert(bus);
        }
    }
    ~WritingBuses()
    {
        for (BusAccess *bus : m_buses)
            bus->rest();
    }
    Q_DISABLE_COPY_MOVE(WritingBuses)

private:
    std::set<BusAccess *> m_buses;
};

// Before anything is written to an encoder.
Checked<void> checkReport(const Arguments &arguments)
{
    const auto path = arguments.value("--report");
    if (!path)
        return {};
    if (arguments.has("--dry-run"))
        return badInput("reportOfDryRun",
                        CommandLine::tr("With --dry-run nothing is written, so there is nothing to report. "
                                        "Leave out --report or --dry-run."));
    if (path->endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive))
        return badInput(
            "reportFormatUnknown",
            CommandLine::tr("\"%1\" ends in .pdf. What was written is saved as a web page (.html), or "
                            "as text under any other name."),
            {*path});
    return checkTargetFile(arguments, *path);
}

// What went wrong with the encoders comes before what goes wrong here.
void addReport(const Call &call, const TransferAccount &account, Answer &answer)
{
    const auto path = call.arguments.value("--report");
    if (!path)
        return;
    const Report report = reportOf(account, call.catalog, QCoreApplication::applicationVersion());
    const bool asHtml = path->endsWith(QStringLiteral(".html"), Qt::CaseInsensitive);
    const QByteArray bytes = asHtml ? reportAsHtml(report) : reportAsText(report).toUtf8();
    const auto saved = replaceFile(*path, bytes, OldFile::goes);
    if (saved)
        answer.text += sentence(CommandLine::tr("Saved in %1."), {*path}) + u'\n';
    else if (answer.complaint)
        answer.complaint->text += u' ' + complaintAbout(saved.error()).text;
    else
        answer.complaint = complaintAbout(saved.error());
}

// The first encoder that does not have everything says why.
std::optional<Complaint> complaintAboutAccount(const Call &call, const TransferAccount &account)
{
    const auto failed = std::ranges::find_if_not(account.encoders, &EncoderAccount::isDone);
    if (failed == account.encoders.end())
        return std::nullopt;
    Complaint complaint =
        notDone("notAllDone", sentence(CommandLine::tr("Not all of it was written, first of all to %1."),
                                       {failed->place.shown()}));
    if (failed->why) {
        const Complaint why = complaintAboutJob(call, failed->place, *failed->why);
        complaint.key = why.key;
        complaint.text += u' ' + why.text;
        complaint.arguments = why.arguments;
    }
    return complaint;
}

// By its place or its station.
Checked<ProjectDevice> deviceNamed(const Call &call, const Project &project, const QString &typed)
{
    const auto place = placeMeant(call, &project, typed);
    const auto devices = devicesOfLink(call, project);
    const bool isUnknown = !place && place.error().key == QStringLiteral("unknownStation");
    if (!place && !isUnknown)
        return tl::unexpected(place.error());
    const auto found = isUnknown ? devices.end() : std::ranges::find(devices, *place, &ProjectDevice::place);
    if (found == devices.end())
        return tl::unexpected(noSuchDevice(typed, devices));
    return *found;
}

} // namespace

Complaint noSuchDevice(const QString &typed, const std::vector<ProjectDevice> &devices)
{
    const QString places =
        listed(devices, [](const ProjectDevice &device) { return device.place().shown(); });
    return complaintAbout({RefusalKind::badInput, RefusalId::noSuchProjectDevice, {typed, places}});
}

std::vector<ProjectDevice> devicesOfLink(const Call &call, const Project &project)
{
    std::vector<ProjectDevice> devices;
    std::ranges::copy_if(project.devices, std::back_inserter(devices),
                         [&](const ProjectDevice &device) { return call.findBus(device.bus) != nullptr; });
    return devices;
}

Checked<std::set<BusId>> contactAll(const Call &call, const std::vector<ProjectDevice> &devices,
                                    Checked<void> (BusAccess::*how)(const Call &, const ProjectDevice &))
{
    std::set<BusId> reached;
    std::map<BusId, Complaint> failed;
    for (const ProjectDevice &device : devices) {
        if (failed.contains(device.bus))
            continue;
        if (const auto there = (call.busOf(device.place()).*how)(call, device); there)
            reached.insert(device.bus);
        else
            failed[device.bus] = there.error();
    }
    if (reached.empty() && !failed.empty())
        return tl::unexpected(failed.begin()->second);
    std::set<BusId> gone;
    for (const auto &[bus, why] : failed) {
        call.terminal.complain(QStringLiteral("%1: %2").arg(call.findBus(bus)->name(), why.text));
        gone.insert(bus);
    }
    return gone;
}

Checked<std::vector<ProjectDevice>> devicesMeant(const Call &call, const Project &project,
                                                 const QString &file)
{
    const std::vector<ProjectDevice> all = devicesOfLink(call, project);
    if (all.empty())
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::projectEmpty, {}}));
    useProject(call, project, file);
    const QStringList named = call.arguments.rest.sliced(1);
    std::vector<ProjectDevice> devices = named.isEmpty() ? all : std::vector<ProjectDevice>();
    for (const QString &place : named) {
        const auto device = deviceNamed(call, project, place);
        if (!device)
            return tl::unexpected(device.error());
        addOnce(devices, *device);
    }
    return contactAll(call, devices).map([&](const std::set<BusId> &) { return devices; });
}

Checked<TransferPlan> plan(const Call &call, std::vector<TransferWish> wishes)
{
    tellModes(call, wishes);
    StopSignals stop; // also between two reads
    for (const TransferWish &wish : wishes)
        if (!readBefore(call, wish) || stop.came())
            return tl::unexpected(aboutCancelling());
    for (TransferWish &wish : wishes)
        if (const BusAccess *bus = call.findBus(wish.place.bus); bus != nullptr && isGone(*bus))
            wish.hindrance = bus->whatIsLost();
    return planTransfer(call.buses, wishes, InWatch::isLeft);
}

FinishedRound runToEnd(const Call &call, const AllowedRound &allowed, JobRound::AfterRefusal afterRefusal)
{
    FinishedRound finished;
    std::map<BusAccess *, std::vector<const EncoderSession *>> encoders;
    for (const EncoderJobs &one : allowed.encoders())
        if (const EncoderSession *encoder = call.buses.encoder(one.place))
            encoders[&call.busOf(one.place)].push_back(encoder);
    std::map<BusAccess *, std::unique_ptr<JobTrace>> traces;
    for (const auto &[bus, its] : encoders)
        traces[bus] = bus->trace(its);
    const WritingBuses writing(call, allowed.encoders());
    JobRound round(call.buses);
    StopSignals stop;
    round.start(allowed.encoders(), afterRefusal);
    while (round.isRunning()) {
        if (stop.came()) {
            finished.wasCancelled = true;
            round.cancel(OnCancel::leaveAsIs);
        }
        passTime(call, round.progress().place);
    }
    finished.results = round.results();
    if (call.arguments.has("--trace"))
        for (const EncoderResult &result : finished.results)
            if (const auto trace = traces.find(call.findBus(result.place.bus)); trace != traces.end())
                finished.traces.push_back(
                    {result.place, trace->second->text(result.place), trace->second->json(result.place)});
    return finished;
}

void addTrace(const Call &call, const FinishedRound &round, Answer &answer)
{
    if (!call.arguments.has("--trace"))
        return;
    QJsonObject json;
    for (const TracedEncoder &one : round.traces) {
        answer.text += u'\n' + one.place.shown() + u'\n' + one.text;
        json.insert(one.place.shown(), one.json);
    }
    answer.text += u'\n';
    answer.json.insert(QStringLiteral("trace"), json);
}

Answer transfer(const Call &call, TransferKind kind, const QString &source, const TransferPlan &plan,
                const std::function<Checked<void>()> &agreed)
{
    Answer answer;
    const auto endingWith = [&](const Complaint &complaint) {
        answer.complaint = complaint;
        return answer;
    };
    if (const auto can = checkReport(call.arguments); !can)
        return endingWith(can.error());
    answer.json.insert(QStringLiteral("plan"), planJson(call, plan));
    if (!call.arguments.has("--json"))
        call.terminal.print(planText(call, plan));
    const std::vector<EncoderJobs> jobs = jobsOf(plan);
    if (call.arguments.has("--dry-run"))
        return answer;
    const auto allowed = eepromConsent(call, jobs, AsksAnyway::yes);
    if (!allowed)
        return endingWith(allowed.error());
    if (!jobs.empty()) {
        const auto agrees =
            consent(call,
                    sentence(CommandLine::tr("Write this to encoders: %1, with at most so many EEPROM "
                                             "writes: %2?"),
                             {QString::number(jobs.size()), QString::number(eepromWritesOf(plan))}),
                    CommandLine::tr("Nothing was written: there is nobody to ask. Add --yes to write, or "
                                    "--dry-run to look only."));
        if (!agrees)
            return endingWith(agrees.error());
    }
    if (const auto mayGoOn = agreed ? agreed() : Checked<void>(); !mayGoOn)
        return endingWith(mayGoOn.error());
    const FinishedRound round =
        runToEnd(call, *allowed,
                 call.arguments.has("--stop") ? JobRound::AfterRefusal::stop : JobRound::AfterRefusal::goOn);
    addTrace(call, round, answer);
    TransferAccount account = accountOf(call.buses, kind, plan, round.results);
    account.source = source;
    answer.text += u'\n' + accountText(call, account);
    answer.json.insert(QStringLiteral("encoders"), accountJson(call, account));
    answer.json.insert(QStringLiteral("eepromWrites"), account.eepromWrites());
    answer.complaint = complaintAboutAccount(call, account);
    addReport(call, account, answer);
    return answer;
}

} // namespace codewheel
