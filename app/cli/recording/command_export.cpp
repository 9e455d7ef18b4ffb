// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/stop_signals.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/jobs.h"
#include "cli/recording/export_wish.h"
#include "recording/recording_archive.h"
#include "trend/trend_files.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QTimeZone>

#include <array>

namespace codewheel {
namespace {

constexpr const char *exportExamples[] = {"export shaft.cwrec",
                                          "export shaft.cwrec -o shaft.csv --tracks 1.0/position,1.0/in.25",
                                          "export night.cwrec -o end.csv --from -60 --unit degrees --locale"};

constexpr auto exportOptions = std::to_array<Option>({
    {"-o", "CSV",
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "the table to make, with a .json of the same name beside it that describes it")},
    {"--tracks", "TRACKS",
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "its columns, with commas: 1.0/position,1.0/speed,1.0/in.25; without: everything")},
    {"--from", "TIME",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "from this time on: 2026-03-01T14:02:05, or +60, seconds "
                                                 "from the beginning, or -60, before the end")},
    {"--to", "TIME", QT_TRANSLATE_NOOP("codewheel::CommandLine", "up to this time")},
    {"--unit", "UNIT",
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "of positions and speeds: steps (the default), turns, degrees or millimetres")},
    {"--mm-per-turn", "MM",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "with millimetres: the way of one turn of a shaft")},
    {"--locale", nullptr,
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "as the spreadsheets of the country want it")},
    {"--dates", nullptr,
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "with a second column of dates and times of day, with their offset from UTC")},
    {"--yes", nullptr,
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace CSV and its .json if they are there")},
});

// Before anything is read: whether both files can be made.
Checked<void> checkTargets(const Arguments &arguments, const QString &recording, const QString &table)
{
    const QString description = TrendFiles::descriptionPath(table);
    for (const QString &path : {table, description}) {
        if (QFileInfo::exists(path) && QFileInfo(path) == QFileInfo(recording))
            return badInput(
                "fileExists",
                CommandLine::tr("%1 is the recording itself. Nothing was saved. Name another file."), {path});
        if (auto can = checkTargetFile(arguments, path); !can)
            return can;
    }
    return {};
}

Checked<CsvStyle> styleMeant(const Arguments &arguments)
{
    if (arguments.has("--locale") && arguments.has("--dates"))
        return badInput(
            "badOption",
            CommandLine::tr("Give --locale or --dates, not both: with --locale the first column has "
                            "dates and times of day."));
    const QTimeZone zone = QTimeZone::systemTimeZone();
    if (arguments.has("--locale"))
        return CsvStyle(QLocale(), zone);
    return arguments.has("--dates") ? CsvStyle::withDates(zone) : CsvStyle();
}

Complaint aboutStopping()
{
    return notDone("exportCancelled", CommandLine::tr("The export was cancelled. Nothing was saved."));
}

// False: a signal came.
bool writeAll(const Call &call, TrendFiles &files, StopSignals &stop)
{
    bool goesOn = true;
    int shown = -1;
    while (goesOn && !stop.came()) {
        goesOn = files.writeSome();
        const int percent = static_cast<int>(files.part() * 100);
        if (std::exchange(shown, percent) != percent && !call.arguments.has("--json"))
            call.terminal.showProgress(
                sentence(CommandLine::tr("Written: %1 %"), {QString::number(percent)}));
    }
    call.terminal.showProgress({});
    return !goesOn;
}

Answer savedTable(const TrendFiles &files, const TrendExtract &extract, const RecordingFacts &facts)
{
    QJsonArray tracks;
    for (const TrendColumn &column : extract.columns)
        tracks.append(column.track.key());
    const QString text =
        sentence(CommandLine::tr("%1: %2 rows of %3 columns, from %4 to %5."),
                 {files.path(), QString::number(files.rows()), QString::number(tracks.size() + 1),
                  recordedTimeText(facts.clock, extract.span.from),
                  recordedTimeText(facts.clock, extract.span.to)}) +
        u'\n' +
        sentence(CommandLine::tr("What the table does not tell is in %1."),
                 {TrendFiles::descriptionPath(files.path())}) +
        u'\n';
    return {.text = text,
            .json = {{QStringLiteral("saved"), files.path()},
                     {QStringLiteral("description"), TrendFiles::descriptionPath(files.path())},
                     {QStringLiteral("rows"), files.rows()},
                     {QStringLiteral("tracks"), tracks}}};
}

Checked<Answer> exportTable(const Call &call, const RecordingArchive &archive, const RecordingFacts &facts,
                            const QString &table)
{
    const auto style = styleMeant(call.arguments);
    if (!style)
        return tl::unexpected(style.error());
    const auto extract = extractMeant(call, facts);
    if (!extract)
        return tl::unexpected(extract.error());
    std::optional<Refusal> trouble; // with what was read from here on
    QObject scope;
    QObject::connect(&archive, &Archive::troubled, &scope, [&](const Refusal &why) { trouble = why; });
    const HistoryOf historyOf = [&archive](const Track &track) {
        return archive.of(track.place, track.channel);
    };
    TrendFiles files(table, *extract, historyOf, *style);
    if (const auto begun = files.begin(); !begun)
        return tl::unexpected(complaintAbout(begun.error()));
    StopSignals stop;
    if (!writeAll(call, files, stop))
        return tl::unexpected(aboutStopping());
    const std::vector<Mark> marks = archive.marks();
    const TrendOrigin origin{.version = QStringLiteral(CODEWHEEL_VERSION),
                             .now = QDateTime::currentDateTime(),
                             .encoders = encodersOf(call, facts, *extract),
                             .marks = {marks.begin(), marks.end()},
                             .dropped = facts.counts.lost};
    if (const auto finished = files.finish(origin); !finished)
        return tl::unexpected(complaintAbout(finished.error()));
    Answer answer = savedTable(files, *extract, facts);
    if (trouble)
        answer.complaint = complaintAbout(*trouble);
    return answer;
}

Checked<Answer> runExport(const Call &call)
{
    const QString &file = call.arguments.rest.front();
    const auto table = call.arguments.value("-o");
    if (table)
        if (const auto can = checkTargets(call.arguments, file, *table); !can)
            return tl::unexpected(can.error());
    const auto archive = RecordingArchive::open(file);
    if (!archive)
        return tl::unexpected(complaintAbout(archive.error()));
    const auto facts = RecordingFacts::of((*archive)->reader());
    if (!facts)
        return tl::unexpected(complaintAbout(facts.error()));
    if (!table)
        return Answer{.text = facts->text(), .json = facts->json()};
    if (!facts->span)
        return badInput("nothingThen", CommandLine::tr("%1 has no values: no encoder has shown anything."),
                        {file});
    return exportTable(call, **archive, *facts, *table);
}

} // namespace

const Subcommand exportCommand{
    .name = "export",
    .usage = "FILE [-o CSV [--tracks TRACKS] [--from TIME] [--to TIME] [--unit UNIT] [--mm-per-turn MM] "
             "[--locale | --dates] [--yes]]",
    .summary =
        QT_TRANSLATE_NOOP("codewheel::CommandLine", "tell what is in a recording, or make a table of it"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Without -o: what was recorded when, of which encoders, how large it is, what was lost, and whether "
        "it\nended. With -o: all its values as a table of comma-separated values, and beside it a JSON file "
        "that tells\nwhat the table cannot. pandas and PlotJuggler open the table as it is. The recording "
        "may "
        "still be written.\n\nNeeds no bus."),
    .examples = exportExamples,
    .options = exportOptions,
    .arguments = {1},
    .textIsAccount = true,
    .run = runExport,
};

} // namespace codewheel
