// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/transfer_call.h"

#include "catalog/catalog.h"
#include "cli/bus_access.h"
#include "cli/consent.h"
#include "cli/eeprom_consent.h"
#include "cli/project_access.h"
#include "cli/target_file.h"
#include "cli/texts.h"
#include "cli/trace.h"
#include "cli/transfer_text.h"
#include "encoder/sentence.h"
#include "project/file_access.h"
#include "report/html_report.h"
#include "report/transfer_report.h"
#include "ring/bus_session.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

QString placesOf(const Project &project, BusId bus)
{
    QStringList places;
    for (const ProjectDevice &device : devicesOn(project, bus))
        places << device.place().toString();
    return places.join(QStringLiteral(", "));
}

// Before anything is written to an encoder.
Checked<void> checkReport(const Arguments &arguments)
{
    const auto path = arguments.value("--report");
    if (!path)
        return {};
    if (arguments.has("--dry-run"))
        return badInput(QStringLiteral("reportOfDryRun"),
                        CommandLine::tr("With --dry-run nothing is written, so there is nothing to report. "
                                        "Leave out --report or --dry-run."));
    if (path->endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive))
        return badInput(
            QStringLiteral("reportFormatUnknown"),
            CommandLine::tr("\"%1\" ends in .pdf. What was written is saved as a web page (.html), or "
                            "as text under any other name."),
            {*path});
    return checkTargetFile(arguments, *path);
}

// What went wrong with the encoders goes before what goes wrong here.
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

// The first encoder that has not got all of it says why.
std::optional<Complaint> complaintAboutAccount(const TransferAccount &account)
{
    const auto failed = std::ranges::find_if_not(account.encoders, &EncoderAccount::isDone);
    if (failed == account.encoders.end())
        return std::nullopt;
    Complaint complaint{ExitCode::refused, QStringLiteral("notAllDone"),
                        sentence(CommandLine::tr("Not all of it was written, first of all to %1."),
                                 {failed->place.toString()})};
    if (failed->why) {
        const Complaint why = complaintAbout(*failed->why);
        complaint.key = why.key;
        complaint.text += u' ' + why.text;
        complaint.arguments = why.arguments;
    }
    return complaint;
}

// By its number or its station.
Checked<ProjectDevice> deviceNamed(const Call &call, const Project &project, const QString &typed)
{
    const auto devices = devicesOn(project, call.bus->id());
    const bool isStation = std::ranges::find(devices, typed, &ProjectDevice::station) != devices.end();
    auto number = Place::parse(typed);
    if (isStation) {
        const auto station = placeOfStation(call, project, typed);
        if (!station)
            return tl::unexpected(station.error());
        number = *station;
    }
    const auto found = std::ranges::find(devices, number, &ProjectDevice::place);
    if (found == devices.end())
        return tl::unexpected(complaintAbout({RefusalKind::badInput,
                                              RefusalId::noSuchProjectDevice,
                                              {typed, placesOf(project, call.bus->id())}}));
    return *found;
}

} // namespace

Checked<std::vector<ProjectDevice>> devicesMeant(const Call &call, const Project &project,
                                                 const QString &file)
{
    const auto all = devicesOn(project, call.bus->id());
    if (all.empty())
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::projectEmpty, {}}));
    useProject(call, project, file);
    call.bus->advance(1); // so that each encoder shows where it stands
    if (call.arguments.rest.size() == 1)
        return std::vector(all.begin(), all.end());
    std::vector<ProjectDevice> devices;
    for (const QString &place : call.arguments.rest.sliced(1)) {
        const auto device = deviceNamed(call, project, place);
        if (!device)
            return tl::unexpected(device.error());
        addOnce(devices, *device);
    }
    return devices;
}

FinishedRound runToEnd(BusSession &bus, const AllowedRound &allowed, JobRound::AfterRefusal afterRefusal)
{
    FinishedRound finished;
    JobRound round(bus);
    QObject scope;
    for (const EncoderJobs &one : allowed.encoders())
        if (EncoderSession *encoder = bus.encoder(one.place))
            QObject::connect(
                encoder, &EncoderSession::exchanged, &scope,
                [&rows = finished.rows[one.place]](const Exchange &row) { rows.push_back(row); });
    round.start(allowed.encoders(), afterRefusal);
    while (round.isRunning())
        bus.advance(1);
    finished.results = round.results();
    return finished;
}

void addTrace(const Call &call, const FinishedRound &round, Answer &answer)
{
    if (!call.arguments.has("--trace"))
        return;
    QJsonObject json;
    for (const auto &[place, rows] : round.rows) {
        const DeviceDescription &device = call.bus->encoder(place)->device();
        answer.text += u'\n' + place.toString() + u'\n' + traceText(device, rows);
        json.insert(place.toString(), traceJson(device, rows));
    }
    answer.text += u'\n';
    answer.json.insert(QStringLiteral("trace"), json);
}

Answer transfer(const Call &call, TransferKind kind, const QString &source, const TransferPlan &plan,
                const std::function<Checked<void>()> &agreed)
{
    Answer answer;
    if (const auto can = checkReport(call.arguments); !can) {
        answer.complaint = can.error();
        return answer;
    }
    answer.json.insert(QStringLiteral("plan"), planJson(*call.bus, plan));
    if (!call.arguments.has("--json"))
        call.terminal.print(planText(*call.bus, plan));
    const std::vector<EncoderJobs> jobs = jobsOf(plan);
    if (call.arguments.has("--dry-run"))
        return answer;
    const auto allowed = eepromConsent(call, jobs, AsksAnyway::yes);
    if (!allowed) {
        answer.complaint = allowed.error();
        return answer;
    }
    if (!jobs.empty()) {
        const auto agrees =
            consent(call,
                    sentence(CommandLine::tr("Write this to encoders: %1, with at most so many EEPROM "
                                             "writes: %2?"),
                             {QString::number(jobs.size()), QString::number(eepromWritesOf(plan))}),
                    CommandLine::tr("Nothing was written: there is nobody to ask. Add --yes to write, or "
                                    "--dry-run to look only."));
        if (!agrees) {
            answer.complaint = agrees.error();
            return answer;
        }
    }
    if (const auto mayGoOn = agreed ? agreed() : Checked<void>(); !mayGoOn) {
        answer.complaint = mayGoOn.error();
        return answer;
    }
    const FinishedRound round =
        runToEnd(*call.bus, *allowed,
                 call.arguments.has("--stop") ? JobRound::AfterRefusal::stop : JobRound::AfterRefusal::goOn);
    addTrace(call, round, answer);
    TransferAccount account = accountOf(*call.bus, kind, plan, round.results);
    account.source = source;
    answer.text += u'\n' + accountText(*call.bus, account);
    answer.json.insert(QStringLiteral("encoders"), accountJson(*call.bus, account));
    answer.json.insert(QStringLiteral("eepromWrites"), account.eepromWrites());
    answer.complaint = complaintAboutAccount(account);
    addReport(call, account, answer);
    return answer;
}

} // namespace codewheel
