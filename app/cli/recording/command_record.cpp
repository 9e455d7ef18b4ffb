// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/project/transfer_call.h"
#include "cli/recording/passing_time.h"
#include "cli/recording/record_news.h"
#include "cli/recording/record_wish.h"
#include "cli/recording/recording_facts.h"
#include "history/histories.h"
#include "history/rough_duration.h"
#include "recording/trigger_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QFile>
#include <QLocale>

namespace codewheel {
namespace {

constexpr const char *recordExamples[] = {
    "record 1.0 2.0 -o shaft.cwrec --for 60",
    "record -o night.cwrec --last 24 --link project --project crane.codewheel",
    "record 3.0 -o jump.cwrec --trigger \"3.0/position>1500\" --before 10 --after 30"};

// After the time is over, until every encoder has told what it showed until then.
constexpr Instant longestSettling = std::chrono::seconds(2);
constexpr Instant betweenWrites = std::chrono::seconds(1); // in virtual time

// What is over tells by itself who was there.
Checked<void> showAll(const Call &call, BusAccess &link)
{
    if (link.length())
        for (const Place place : link.knownPlaces())
            if (const auto shown = link.encoder(call, place.node, false); !shown)
                return tl::unexpected(shown.error());
    return {};
}

// Lets each show its position. A serial line knows only the encoders that somebody names.
Checked<std::set<Place>> allEncoders(const Call &call)
{
    if (call.project != nullptr)
        if (const auto there = contactAll(call, devicesOfLink(call, *call.project)); !there)
            return tl::unexpected(there.error());
    std::set<Place> places;
    for (BusAccess *link : call.links) {
        const std::size_t before = places.size();
        if (const auto shown = showAll(call, *link); !shown)
            return tl::unexpected(shown.error());
        for (const Place place : link->bus().places())
            if (link->bus().isOpen() && link->bus().encoder(place) != nullptr)
                places.insert(place);
        if (places.size() == before)
            call.terminal.complain(
                sentence(CommandLine::tr("Nobody has said which encoders the bus \"%1\" has: it is left out. "
                                         "Name their places, or give a project that has them. "
                                         "codewheel-cli scan finds them."),
                         {link->name()}));
    }
    if (places.empty())
        return badInput("nothingToRecord", CommandLine::tr("There is no encoder to record. Name a PLACE."));
    return places;
}

// It may come later: the coding may become known, the mode may change.
void noteWhatIsNotShown(const Call &call, const RecordingTrigger &trigger)
{
    const auto *threshold = std::get_if<ThresholdTrigger>(&trigger);
    if (threshold != nullptr && !call.buses.encoder(threshold->place)->showsPosition())
        call.terminal.complain(
            sentence(CommandLine::tr("The encoder at %1 shows no position: the trigger cannot come before it "
                                     "does. If its make is not known, --device names it."),
                     {threshold->place.shown()}));
}

// Empty: one of the buses goes on for ever.
std::optional<Instant> lengthOfAll(const Call &call)
{
    Instant longest{};
    for (const BusAccess *link : call.links) {
        const auto its = link->length();
        if (!its)
            return std::nullopt;
        longest = std::max(longest, *its);
    }
    return longest;
}

Checked<RecordWish> completeWish(const Call &call)
{
    auto wish = RecordWish::of(call.arguments);
    if (!wish)
        return wish;
    if (const auto text = call.arguments.value("--trigger")) {
        const auto trigger = triggerMeant(call, *text);
        if (!trigger)
            return tl::unexpected(trigger.error());
        wish->plan.trigger = *trigger;
    }
    const bool isOfAll = call.arguments.rest.isEmpty();
    const auto places = isOfAll ? allEncoders(call) : encodersAt(call);
    if (!places)
        return tl::unexpected(places.error());
    wish->encoders = *places;
    if (!call.arguments.has("--for") && !wish->plan.trigger)
        wish->duration = wish->plan.extent.after = lengthOfAll(call);
    if (!isOfAll)
        wish->plan.places = *places;
    if (wish->plan.trigger)
        noteWhatIsNotShown(call, *wish->plan.trigger);
    return wish;
}

QString beginText(const RecordWish &wish)
{
    const RecordingPlan &plan = wish.plan;
    const auto seconds = [](Instant duration) { return roughDurationText(duration, QLocale()); };
    QString text = sentence(CommandLine::tr("Recording into %1: %2."),
                            {wish.target(), listed(wish.encoders, &Place::shown)}) +
                   u'\n';
    if (plan.trigger)
        text += sentence(CommandLine::tr("It begins with %1."), {triggerKey(*plan.trigger)}) + u' ';
    if (wish.plan.extent.after)
        text += sentence(CommandLine::tr("It takes %1."), {seconds(*wish.plan.extent.after)}) + u' ';
    return text + CommandLine::tr("Ctrl+C ends it.") + u'\n';
}

// Until the time is over, the recording has ended for another reason, or a signal comes.
void recordUntilEnd(const RecordWish &wish, const Call &call, PassingTime &time, BusRecorder &recorder,
                    StopSignals &stop)
{
    RecordNews news(call, recorder);
    Instant written{};
    while (recorder.state() != BusRecorder::State::ended && !stop.came()) {
        time.goOn(stop);
        news.look(time.passed());
        if (time.isVirtual() && time.passed() - written >= betweenWrites) { // it may be a minute each second
            written = time.passed();
            recorder.flush();
        }
        if (wish.duration && time.passed() > *wish.duration + longestSettling) // nobody shows anything
            break;
    }
    recorder.end();
    news.look(time.passed());
}

Complaint aboutNothing(const RecordWish &wish)
{
    const QString why = wish.plan.trigger ? CommandLine::tr("The trigger has not come.")
                                          : CommandLine::tr("No encoder has shown anything.");
    const QString what = wish.isOnServer()
                             ? CommandLine::tr("Nothing was recorded; the recording on %1 is empty.")
                             : CommandLine::tr("Nothing was recorded, and there is no file %1.");
    return notDone(wish.plan.trigger ? "notTriggered" : "nothingShown",
                   why + u' ' + sentence(what, {wish.target()}), {wish.target()});
}

// What is wrong with the file has been told when it began.
std::optional<Complaint> whyIncomplete(const Call &call, const RecordWish &wish, const BusRecorder &recorder)
{
    const auto problem = recorder.status().problem;
    if (problem && wish.isOnServer()) // where the rest waits
        return complaintAbout(*problem);
    if (problem)
        return Complaint{
            ExitCode::refused, refusalKey(problem->id),
            sentence(CommandLine::tr("Not everything is in %1: it could not be written until the "
                                     "end."),
                     {wish.target()}),
            problem->arguments};
    for (const BusAccess *bus : call.links)
        if (bus->bus().isOpen() && !bus->isConnected())
            return bus->linkLost();
    return std::nullopt;
}

Answer recordedAnswer(const Call &call, const RecordWish &wish, const BusRecorder &recorder)
{
    auto why = whyIncomplete(call, wish, recorder);
    if (!recorder.span() && !why) {
        if (!wish.isOnServer())
            QFile::remove(wish.target()); // it has nothing, and would be in the way of the next attempt
        return {.complaint = aboutNothing(wish)};
    }
    const auto server = recorder.status().server;
    const auto facts =
        RecordingReader::open(server ? server->address : wish.target())
            .and_then([](const RecordingReader &reader) { return RecordingFacts::of(reader); });
    if (!facts)
        return {.complaint = why ? why : complaintAbout(facts.error())};
    Answer answer{.text = facts->text(), .json = facts->json(), .complaint = why};
    if (wish.plan.trigger) {
        answer.json.insert(QStringLiteral("trigger"), triggerKey(*wish.plan.trigger));
        answer.json.insert(QStringLiteral("hasTriggered"), recorder.span().has_value());
    }
    return answer;
}

Checked<Answer> runRecord(const Call &call)
{
    const auto wish = completeWish(call);
    if (!wish)
        return tl::unexpected(wish.error());
    Buses buses;
    for (const BusAccess *link : call.links)
        buses.add(link->bus());
    Histories histories(buses);
    if (wish->plan.extent.before == Instant(0))
        histories.setLimit(0); // memory is for what is before
    StopSignals stop;          // before there is a thread that could get them
    PassingTime time(call, wish->plan.extent.after ? PassingTime::Pace::asFastAsPossible
                                                   : PassingTime::Pace::byTheClock);
    const auto recorder = BusRecorder::begin(buses, histories, wish->plan, [&time] { return time.now(); });
    if (!recorder)
        return tl::unexpected(complaintAbout(recorder.error()));
    if (!call.arguments.has("--json"))
        call.terminal.print(beginText(*wish));
    recordUntilEnd(*wish, call, time, **recorder, stop);
    return recordedAnswer(call, *wish, **recorder);
}

} // namespace

const Subcommand recordCommand{
    .name = "record",
    .usage = "[PLACE...] -o FILE | --to ADDRESS [--for SECONDS | --trigger TRIGGER [--before SECONDS] "
             "[--after SECONDS]] "
             "[--last HOURS] [--max-size MB] [--keep-free MB] [--no-traffic]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "record what encoders show, at once or when something happens"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Records into a file what the encoders show, every cycle and every answer, with messages, words "
        "and\nrequests: of the encoders at PLACE, or of all that are known. Writes nothing to any encoder; "
        "those on a\nserial line are polled, as by monitor.\n\n"
        "A real bus is recorded as time passes. The training bus has virtual time, and is recorded at once "
        "where it\nis known how long. Whatever happens to the program, all up to the last second is in the "
        "file. It is made\nanew: a recording is never written over. codewheel-cli export tells what is in "
        "it, and makes a table of it.\n\n"
        "Several stations can record on one PostgreSQL server. While it is away what is recorded waits "
        "on this\ncomputer, and follows."),
    .examples = recordExamples,
    .options = recordOptions,
    .arguments = {0, ArgumentCount::any},
    .needsBus = true,
    .textIsAccount = true,
    .run = runRecord,
};

} // namespace codewheel
