// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/parameter_text.h"
#include "cli/encoder/told_mode.h"
#include "cli/encoder/value_lines.h"
#include "cli/project/project_of_call.h"
#include "cli/project/transfer_call.h"
#include "journal/ledger_keeper.h"
#include "transfer/project_places.h"
#include "transfer/values_before.h"
#include "vocabulary/local_time.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr const char *restoreExamples[] = {"restore 1.0 --list", "restore 1.0 --at 14:02 --dry-run",
                                           "restore 1.0 --at 2026-03-01T14:02 --yes"};

constexpr std::array restoreOptions{
    Option{"--at", "TIME",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "of the write at this time: 2026-03-01T14:02, or 14:02 of today; else of the "
                             "newest")},
    Option{"--list", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "list what there is, and write nothing")},
    inPositionModeOption,
    transferDryRun,
    transferReport,
    traceOption,
    transferYes,
    beyondLimitOption,
    ledgerOption,
};

// For an encoder that can report its serial number, the ledger keeps the values by that.
Checked<std::vector<ValuesBefore>> valuesBefore(const Call &call, EncoderSession &encoder)
{
    const LedgerKeeper *ledger = call.busOf(encoder.place()).ledger();
    if (ledger == nullptr)
        return std::vector<ValuesBefore>();
    const FindValuesBefore find = valuesBeforeOf(*ledger);
    auto all = find(encoder.place());
    if (!all.empty() || !encoder.can().serialNumber || encoder.known(Parameter::serialNumber))
        return all;
    const FinishedJob read =
        runToEnd(call, {encoder, ReadParameters{.parameters = {Parameter::serialNumber}}});
    if (read.wasCancelled)
        return tl::unexpected(aboutCancelling());
    if (!read.outcome.result)
        return tl::unexpected(complaintAboutJob(call, encoder.place(), read.outcome.result.error()));
    return find(encoder.place());
}

Checked<TypedTime> timeMeant(const QString &typed, const QDateTime &now)
{
    const QString text = typed.contains(u'T') ? typed : now.date().toString(Qt::ISODate) + u'T' + typed;
    if (const auto at = TypedTime::parse(text, now.timeZone()))
        return *at;
    return badInput("badTime",
                    CommandLine::tr("\"%1\" is not a time. Write it as 14:02 or 2026-03-01T14:02."), {typed});
}

// With --at.
Checked<std::optional<TypedTime>> timeMeant(const Call &call)
{
    const auto typed = call.arguments.value("--at");
    if (!typed)
        return std::nullopt;
    const QDateTime now = call.buses.now({});
    return timeMeant(*typed, now.isValid() ? now : QDateTime::currentDateTime()); // a line is not open yet
}

Checked<ValuesBefore> valuesMeant(const Call &call, const std::vector<ValuesBefore> &all,
                                  const std::optional<TypedTime> &at)
{
    if (!at)
        return all.front();
    const auto found = std::ranges::find_if(all, [&](const ValuesBefore &one) { return at->covers(one.at); });
    if (found == all.end())
        return badInput(
            "noWriteThen",
            CommandLine::tr(
                "No earlier values of %1 are kept for a write at %2. See codewheel-cli restore %1 --list."),
            {all.front().place.shown(), *call.arguments.value("--at")});
    return *found;
}

QString localTime(const ValuesBefore &before, const QDateTime &now)
{
    const QDateTime at = before.at.toTimeZone(now.timeZone());
    return at.toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss")) + offsetIfTwice(at);
}

QString assignments(const DeviceDescription &device, const ParameterValues &values)
{
    return listed(values, [&](const ParameterValue &value) {
        return QString(parameterKey(value.parameter) + u'=' + typedValue(&device, value));
    });
}

Answer listedValues(const Call &call, const EncoderSession &encoder, const std::vector<ValuesBefore> &all)
{
    const QDateTime now = call.buses.now(encoder.place());
    std::set<Place> places;
    for (const ValuesBefore &before : all)
        places.insert(before.writtenAt);
    BusNames::tellApart(call, places);
    const bool isOfSeveralBuses = !places.empty() && places.begin()->bus != places.rbegin()->bus;
    TextTable table;
    QJsonArray json;
    for (const ValuesBefore &before : all) {
        QStringList cells{localTime(before, now), assignments(encoder.device(), before.values)};
        if (isOfSeveralBuses)
            cells.insert(1, BusNames::apart(call, before.writtenAt));
        table.add(cells);
        json.append(placeJson(call, before.writtenAt,
                              {{QStringLiteral("at"), before.at.toUTC().toString(Qt::ISODateWithMs)},
                               {QStringLiteral("device"), before.deviceKey},
                               {QStringLiteral("values"), valuesJson(encoder, before.values)}}));
    }
    Answer answer{.text = table.toString(), .json = {{QStringLiteral("valuesBefore"), json}}};
    addPlace(answer.json, call, encoder.place());
    return answer;
}

Checked<Answer> runRestore(const Call &call)
{
    const auto at = timeMeant(call);
    if (!at)
        return tl::unexpected(at.error());
    const auto encoder = encoderAt(call, call.arguments.rest.front());
    if (!encoder)
        return tl::unexpected(encoder.error());
    const ProjectPlaces places(call.project ? *call.project : Project(), call.buses);
    if (const auto why = places.hindrance((*encoder)->place()))
        return tl::unexpected(complaintAbout(*why));
    const auto all = valuesBefore(call, **encoder);
    if (!all)
        return tl::unexpected(all.error());
    if (all->empty())
        return tl::unexpected(complaintAbout(whyNothingBefore(**encoder)));
    if (call.arguments.has("--list"))
        return listedValues(call, **encoder, *all);
    const auto before = valuesMeant(call, *all, *at);
    if (!before)
        return tl::unexpected(before.error());
    return plan(call, {wishToRestore(*before, places)}).map([&](const TransferPlan &planned) {
        return transfer(call, TransferKind::restore, timeOf(*before, call.buses.now(before->place)), planned);
    });
}

} // namespace

const Subcommand restoreCommand{
    .name = "restore",
    .usage = "PLACE [--at TIME | --list] [--in-position-mode] [--dry-run] [--report FILE] [--yes] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "write the values again that an encoder had before a write"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "The ledger of EEPROM writes keeps with each write what was known of the encoder before, and what "
        "was\n"
        "read then. --list tells what there is, the newest first. Without --at the newest is restored: what\n"
        "differs is shown, asked for, written as by \"transfer\", and accounted for. An encoder that can "
        "tell "
        "its\n"
        "serial number is asked for that where nothing is kept for its place."),
    .examples = restoreExamples,
    .options = restoreOptions,
    .arguments = {1},
    .needsBus = true,
    .textIsAccount = true,
    .run = runRestore,
};

} // namespace codewheel
