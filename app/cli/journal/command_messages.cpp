// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/project/project_of_call.h"
#include "journal/message_fields.h"
#include "journal/message_search.h"
#include "journal/message_writer.h"
#include "journal_files.h"
#include "project/file_replacement.h"
#include "project/project.h"
#include "vocabulary/local_time.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <limits>

namespace codewheel {
namespace {

constexpr const char *messagesExamples[] = {"messages", "messages --severity fault --from 2026-03-01",
                                            "messages --place 1.0 --text steps --export steps.html"};

constexpr auto messagesOptions = std::to_array<Option>({
    {"--file", "FILE",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "of this file, in place of the user's own")},
    {"--severity", "SEVERITY",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "information, attention or fault: this or worse")},
    {"--place", "PLACE", QT_TRANSLATE_NOOP("codewheel::CommandLine", "of this device; \"bus\": of none")},
    {"--bus", "BUS",
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "of this bus and its devices: its number, or its name in the project")},
    {"--from", "TIME",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "from this time on: 2026-03-01 or 2026-03-01T14:02")},
    {"--until", "TIME", QT_TRANSLATE_NOOP("codewheel::CommandLine", "before this time")},
    {"--text", "TEXT", QT_TRANSLATE_NOOP("codewheel::CommandLine", "with this text anywhere in the line")},
    {"--last", "N", QT_TRANSLATE_NOOP("codewheel::CommandLine", "the newest N (100); 0: all")},
    {"--export", "FILE",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "write all that match to FILE, .csv or .html")},
    {"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace FILE if it is there")},
});

constexpr qint64 portion = 5'000; // ids looked at together
constexpr int usualLast = 100;

Checked<std::optional<TypedTime>> timeFrom(const Call &call, const char *option)
{
    const auto text = call.arguments.value(option);
    if (!text)
        return std::nullopt;
    const auto at = TypedTime::parse(*text, QTimeZone::systemTimeZone());
    if (!at)
        return badInput("badTime",
                        CommandLine::tr("\"%1\" is not a time. Write it as 2026-03-01 or 2026-03-01T14:02."),
                        {*text});
    return at;
}

// By its name in the project, otherwise by its number. Empty: there is none.
std::optional<BusId> busTyped(const Call &call, const QString &typed)
{
    if (call.project != nullptr)
        for (const PlannedBus &planned : call.project->buses)
            if (planned.name == typed)
                return planned.id;
    const int number = typed.toInt();
    return number > 0 ? std::optional(BusId{number}) : std::nullopt;
}

tl::unexpected<Complaint> unknownBus(const Call &call, const QString &typed)
{
    if (call.project == nullptr)
        return badInput("badBus",
                        CommandLine::tr("\"%1\" is not a bus. Write its number, or its name with --project."),
                        {typed});
    return badInput("badBus", CommandLine::tr("\"%1\" is not a bus of the project. Its buses are: %2."),
                    {typed, listed(call.project->buses, &PlannedBus::name)});
}

// As it is listed: "1.0", "Crane 2/1.0", "4/03".
std::optional<Place> placeTyped(const Call &call, const QString &typed)
{
    const qsizetype slash = typed.lastIndexOf(u'/');
    if (slash < 0)
        return Place::parse(typed);
    const auto bus = busTyped(call, typed.first(slash));
    const auto place = Place::parse(typed.sliced(slash + 1));
    return bus && place ? std::optional(Place{*bus, place->node}) : Place::parse(typed);
}

Checked<MessageFilter::Where> busFrom(const Call &call, const QString &bus)
{
    if (call.arguments.has("--place"))
        return badInput(
            "badOption",
            CommandLine::tr("Give --place or --bus, not both. A place on another bus is written as 3/1.0."));
    const auto id = busTyped(call, bus);
    if (!id)
        return unknownBus(call, bus);
    return MessageFilter::Where{.all = false, .at = Place{*id, {}}};
}

Checked<MessageFilter::Where> placeFrom(const Call &call)
{
    if (const auto bus = call.arguments.value("--bus"))
        return busFrom(call, *bus);
    const auto text = call.arguments.value("--place");
    if (!text)
        return MessageFilter::Where{};
    const auto number = placeTyped(call, *text);
    if (!number && *text != QStringLiteral("bus"))
        return badInput("badPlace",
                        CommandLine::tr("\"%1\" is not a place. Write it as 1.0, with its bus as 3/1.0, or "
                                        "with the name of the bus and --project; or write bus."),
                        {*text});
    return MessageFilter::Where{.all = false, .at = number};
}

Checked<MessageFilter> filterFrom(const Call &call)
{
    MessageFilter filter;
    if (const auto text = call.arguments.value("--severity")) {
        const auto severity = severityFromKey(*text);
        if (!severity)
            return badInput(
                "badSeverity",
                CommandLine::tr("\"%1\" is not a severity. There are: information, attention, fault."),
                {*text});
        filter.least = *severity;
    }
    const auto place = placeFrom(call);
    const auto from = timeFrom(call, "--from");
    const auto until = timeFrom(call, "--until");
    if (!place)
        return tl::unexpected(place.error());
    if (!from || !until)
        return tl::unexpected(from ? until.error() : from.error());
    filter.place = *place;
    // Of an hour that comes twice, from the first to the last.
    if (*from)
        filter.from = (*from)->first.toMSecsSinceEpoch();
    if (*until)
        filter.until = (*until)->last.toMSecsSinceEpoch();
    filter.text = call.arguments.value("--text").value_or(QString());
    return filter;
}

Complaint databaseComplaint(const QString &file, const DatabaseError &error)
{
    return complaintAbout({RefusalKind::link, RefusalId::databaseFailed, {file, error.reason}});
}

// The newest `last` that match, oldest first.
Stored<std::vector<qint64>> newest(const MessageTable &table, const MessageFilter &filter, int last)
{
    const auto span = table.span();
    if (!span)
        return tl::unexpected(span.error());
    const auto wanted = last == 0 ? std::numeric_limits<std::size_t>::max() : static_cast<std::size_t>(last);
    MessageTextMatcher matcher(filter.text);
    std::vector<qint64> ids;
    for (qint64 end = span->last; end > 0 && end >= span->first && ids.size() < wanted; end -= portion) {
        auto found = fittingIds(table, filter, matcher, std::max(span->first, end - portion + 1), end);
        if (!found)
            return tl::unexpected(found.error());
        found->insert(found->end(), ids.begin(), ids.end());
        ids = std::move(*found);
    }
    if (ids.size() > wanted)
        ids.erase(ids.begin(), ids.end() - static_cast<std::ptrdiff_t>(wanted));
    return ids;
}

QJsonObject toJson(const StoredMessage &message)
{
    const auto parsed = [](const QString &json) { return QJsonDocument::fromJson(json.toUtf8()); };
    return {{QStringLiteral("time"),
             QDateTime::fromMSecsSinceEpoch(message.at, Qt::UTC).toString(Qt::ISODateWithMs)},
            {QStringLiteral("severity"), severityKey(message.severity)},
            {QStringLiteral("bus"), message.place ? QJsonValue(message.place->bus.number) : QJsonValue()},
            {QStringLiteral("place"), textJson(placeText(message.place))},
            {QStringLiteral("code"), message.code},
            {QStringLiteral("arguments"), parsed(message.arguments).array()},
            {QStringLiteral("refusal"),
             message.refusal.isEmpty() ? QJsonValue() : QJsonValue(parsed(message.refusal).object())}};
}

QString shownPlaceOf(const Call &call, const StoredMessage &message)
{
    return message.place && !message.place->isEmpty() ? BusNames::apart(call, *message.place)
                                                      : placeName(message.place);
}

Answer listedMessages(const Call &call, const std::vector<StoredMessage> &messages)
{
    std::set<Place> places;
    for (const StoredMessage &message : messages)
        if (message.place)
            places.insert(*message.place);
    BusNames::tellApart(call, places);
    TextTable table;
    QJsonArray json;
    for (const StoredMessage &message : messages) {
        table.add({messageTime(message.at), severityName(message.severity), shownPlaceOf(call, message),
                   messageText(message)});
        json.append(toJson(message));
    }
    return {.text =
                messages.empty() ? CommandLine::tr("No stored message matches.") + u'\n' : table.toString(),
            .json = {{QStringLiteral("messages"), json}}};
}

struct ExportTarget
{
    QString path;
    MessageWriter::Format format;
};

// Where to write them; empty: they are listed.
Checked<std::optional<ExportTarget>> exportTargetOf(const Arguments &arguments)
{
    const auto path = arguments.value("--export");
    if (!path)
        return std::nullopt;
    const auto format = MessageWriter::formatOf(*path);
    if (!format)
        return badInput("badFormat",
                        CommandLine::tr("\"%1\" names no format. Let the name end in .csv or .html."),
                        {*path});
    if (const auto can = checkTargetFile(arguments, *path); !can)
        return tl::unexpected(can.error());
    return ExportTarget{*path, *format};
}

// Piece by piece: a million messages need no memory. Errors of the file are reported when it is replaced.
Stored<void> writeAll(const MessageTable &table, const std::vector<qint64> &ids, MessageWriter &writer)
{
    bool isWriting = writer.begin();
    for (auto begin = ids.begin(); isWriting && begin != ids.end();) {
        const auto end = begin + std::min<std::ptrdiff_t>(portion, ids.end() - begin);
        const auto messages = table.read(std::vector<qint64>(begin, end));
        if (!messages)
            return tl::unexpected(messages.error());
        isWriting = writer.write(*messages);
        begin = end;
    }
    writer.end();
    return {};
}

Checked<Answer> exported(const MessageTable &table, const QString &database, const std::vector<qint64> &ids,
                         const ExportTarget &target)
{
    FileReplacement file(target.path);
    MessageWriter writer(file, target.format);
    if (const auto begun = file.begin(); !begun)
        return tl::unexpected(complaintAbout(begun.error()));
    if (const auto written = writeAll(table, ids, writer); !written)
        return tl::unexpected(databaseComplaint(database, written.error()));
    if (const auto replaced = file.replace(); !replaced)
        return tl::unexpected(complaintAbout(replaced.error()));
    const auto count = static_cast<qint64>(ids.size());
    const QString done =
        sentence(CommandLine::tr("Messages written to %1: %2."), {target.path, QString::number(count)}) +
        u'\n';
    return Answer{.text = done,
                  .json = {{QStringLiteral("file"), target.path}, {QStringLiteral("count"), count}},
                  .done = done};
}

Checked<Answer> runMessages(const Call &call)
{
    const auto filter = filterFrom(call);
    const auto target = exportTargetOf(call.arguments);
    if (!target)
        return tl::unexpected(target.error());
    const auto last =
        call.arguments.number("--last", *target ? 0 : usualLast, 0, std::numeric_limits<int>::max());
    if (!filter)
        return tl::unexpected(filter.error());
    if (!last)
        return tl::unexpected(last.error());
    const QString file = call.arguments.value("--file").value_or(messageFile(userJournalFolder()));
    if (!QFileInfo::exists(file)) // looking makes none
        return Answer{.text = sentence(CommandLine::tr("No messages are stored in %1."), {file}) + u'\n',
                      .json = {{QStringLiteral("messages"), QJsonArray()}}};
    const auto table = MessageTable::open(DatabasePlace::file(file));
    if (!table)
        return tl::unexpected(databaseComplaint(file, table.error()));
    const auto ids = newest(*table, *filter, *last);
    if (!ids)
        return tl::unexpected(databaseComplaint(file, ids.error()));
    if (*target)
        return exported(*table, file, *ids, **target);
    const auto messages = table->read(*ids);
    if (!messages)
        return tl::unexpected(databaseComplaint(file, messages.error()));
    return listedMessages(call, *messages);
}

} // namespace

const Subcommand messagesCommand{
    .name = "messages",
    .usage = "[--severity SEVERITY] [--place PLACE] [--bus BUS] [--from TIME] [--until TIME] [--text TEXT] "
             "[--last N] [--export FILE [--yes]]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list or export the stored messages"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Lists the messages that the window keeps on disk, oldest first: those that fit all "
        "that is given.\nNeeds no bus."),
    .examples = messagesExamples,
    .options = messagesOptions,
    .arguments = {0},
    .run = runMessages,
};

} // namespace codewheel
