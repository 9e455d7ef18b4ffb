// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/save_report.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/project/project_of_call.h"
#include "cli/project/transfer_call.h"
#include "journal/ledger.h"
#include "journal_files.h"
#include "report/deviations.h"
#include "report/kept_counts.h"
#include "report/live_encoders.h"
#include "report/make_report.h"
#include "transfer/value_store.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QLocale>

#include <array>

namespace codewheel {
namespace {

constexpr const char *reportExamples[] = {"report crane.codewheel -o crane.pdf",
                                          "report crane.codewheel -o crane.html --read"};

constexpr std::array reportOptions{
    Option{"-o", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "where to save the report: a name in .html or .pdf")},
    Option{"--read", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "ask the encoders of the bus what they have; hides their positions meanwhile")},
    Option{"--yes", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace FILE if it is there; do not ask where "
                                                       "the budget of an EEPROM is used")},
    beyondLimitOption,
    ledgerOption,
};

struct ReportTarget
{
    QString path;
    ReportFormat format = ReportFormat::html;
};

Checked<ReportTarget> reportTargetOf(const Arguments &arguments)
{
    const auto path = arguments.value("-o");
    if (!path)
        return badInput(
            "missingFile",
            CommandLine::tr("Name the file of the report: -o FILE, with a name that ends in .html "
                            "or .pdf."));
    const auto format = reportFormat(*path);
    if (!format)
        return badInput(
            "reportFormatUnknown",
            CommandLine::tr("\"%1\" ends neither in .html nor in .pdf. A report is a web page or a "
                            "PDF."),
            {*path});
    if (const auto can = checkTargetFile(arguments, *path); !can)
        return tl::unexpected(can.error());
    return ReportTarget{*path, *format};
}

// The cams of an encoder are read if the project wants any: its mode changes for that.
EncoderJobs jobsToRead(const ProjectDevice &planned, const EncoderSession &encoder)
{
    EncoderJobs jobs = jobsToStore(encoder, false);
    if (!encoder.can().cams || planned.wantedCams.empty())
        return jobs;
    const Reading &reading = encoder.latest();
    ReadCams read;
    for (const CamProgram &program : planned.wantedCams)
        read.programs.push_back(program.number);
    read.afterwards = {reading.mode.value_or(Mode::position), reading.camProgram.value_or(0)};
    jobs.jobs.emplace_back(std::move(read));
    return jobs;
}

Checked<AllowedRound> roundToRead(const Call &call, const Project &project)
{
    std::vector<EncoderJobs> jobs;
    for (const auto &[planned, encoder] : connectedEncoders(project, call.buses))
        jobs.push_back(jobsToRead(*planned, *encoder));
    return eepromConsent(call, std::move(jobs), AsksAnyway::no);
}

// Reads what the encoders of the project have; returns why one could not be read, or nothing.
std::optional<Complaint> readEncoders(const Call &call, const AllowedRound &round)
{
    for (const EncoderResult &result : runToEnd(call, round, JobRound::AfterRefusal::goOn).results)
        if (result.why)
            return Complaint{ExitCode::refused, refusalKey(result.why->id),
                             sentence(CommandLine::tr("%1 could not be read: %2"),
                                      {result.place.shown(), refusalText(*result.why)}),
                             result.why->arguments};
    return std::nullopt;
}

// A report is read by people: with the group separators that the command line omits.
class LocaleOfPeople
{
public:
    LocaleOfPeople() { QLocale::setDefault(QLocale(m_before.name())); }
    ~LocaleOfPeople() { QLocale::setDefault(m_before); }
    Q_DISABLE_COPY_MOVE(LocaleOfPeople)

private:
    QLocale m_before;
};

Answer savedReport(const Call &call, const ReportInput &input, const ReportTarget &target)
{
    const auto sheets = [&] {
        const LocaleOfPeople locale;
        return saveReport(makeReport(input, call.catalog), target.path, target.format);
    }();
    if (!sheets)
        return {.complaint = complaintAbout(sheets.error())};
    const DeviationCounts counts = countDeviations(reportedDevices(input, call.catalog));
    Answer answer;
    answer.text =
        sentence(CommandLine::tr("Saved in %1."), {target.path}) + u'\n' +
        sentence(CommandLine::tr("Deviations of encoders from what is wanted: %1; not compared: %2."),
                 {QString::number(counts.deviations), QString::number(counts.notKnown)}) +
        u'\n';
    answer.json = {{QStringLiteral("saved"), target.path},
                   {QStringLiteral("deviations"), counts.deviations},
                   {QStringLiteral("notCompared"), counts.notKnown}};
    if (target.format == ReportFormat::pdf)
        answer.json.insert(QStringLiteral("pages"), *sheets);
    return answer;
}

// From the file that keeps the writes to real encoders, or the one named. Looking creates none.
Checked<void> addLedger(const Call &call, const QString &project, ReportInput &input)
{
    const QString file = call.arguments.value("--ledger").value_or(ledgerFile(userJournalFolder()));
    if (!QFileInfo::exists(file))
        return {};
    const auto ledger = Ledger::open(DatabasePlace::file(file));
    if (!ledger)
        return tl::unexpected(
            complaintAbout({RefusalKind::link, RefusalId::databaseFailed, {file, ledger.error().reason}}));
    addKept(input, *ledger, call.catalog, QFileInfo(project).absoluteFilePath());
    return {};
}

Checked<Answer> runReport(const Call &call)
{
    const QString &name = call.arguments.rest.front();
    const auto target = reportTargetOf(call.arguments);
    if (!target)
        return tl::unexpected(target.error());
    ReportInput input{.project = *call.named,
                      .file = QFileInfo(name).fileName(),
                      .version = QStringLiteral(CODEWHEEL_VERSION),
                      .now = QDateTime::currentDateTime()};
    std::optional<Complaint> notRead;
    if (call.arguments.has("--read")) {
        useProject(call, input.project, name);
        const auto there = contactAll(call, devicesOfLink(call, input.project));
        const auto round = roundToRead(call, input.project);
        if (!round)
            return tl::unexpected(round.error());
        notRead = there ? readEncoders(call, *round) : std::optional(there.error());
        addConnected(input, call.buses);
    }
    if (const auto added = addLedger(call, name, input); !added)
        return tl::unexpected(added.error());
    Answer answer = savedReport(call, input, *target);
    if (!answer.complaint)
        answer.complaint = notRead;
    return answer;
}

} // namespace

const Subcommand reportCommand{
    .name = "report",
    .usage = "PROJECT -o FILE [--read] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "make the commissioning report of a project"),
    .details =
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "Saves the commissioning report of a project, as a web page or as a PDF on A4: "
                          "structure, parameters\n"
                          "and cams of each encoder with what is known of them, deviations, EEPROM writes, "
                          "and a place to sign.\n"
                          "\n"
                          "What is known is what the project has stored. With --read, the encoders are asked "
                          "for their parameters,\n"
                          "and for the cam programs the project wants; they show no position meanwhile. The "
                          "bus is compared with\n"
                          "the project then. A FILE that is there already is replaced with --yes only."),
    .examples = reportExamples,
    .options = reportOptions,
    .arguments = {1},
    .busOption = "--read",
    .namesProject = true,
    .textIsAccount = true,
    .run = runReport,
};

} // namespace codewheel
