// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_lines.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "jobs/step_text.h"
#include "jobs/values_to_write.h"
#include "jobs/write_plan.h"
#include "transfer/project_places.h"
#include "transfer/transfer_words.h"
#include "transfer/value_store.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/known_words.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/known_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct TransferLines
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TransferLines)
};

QString lineName(const QString &device, const QString &station)
{
    const QString name = device.isEmpty() ? TransferLines::tr("not there") : device;
    return station.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, station);
}

ReviewRow headOf(const EncoderPlan &plan)
{
    return {.cells = {plan.place.shown(),
                      lineName(plan.device, plan.station),
                      {},
                      {},
                      {},
                      plan.isWritten() ? QString::number(plan.eepromWrites) : QString()},
            .tip = transfer_words::summary(plan),
            .kind = ReviewRow::Kind::head,
            .place = plan.place,
            .canBeChosen = plan.isWritten(),
            .isThere = !plan.hindrance && plan.jobs.empty(),
            .isHindered = plan.hindrance.has_value()};
}

ReviewRow note(Place place, const QString &text, bool isHindered = false)
{
    return {.cells = {{}, text},
            .tip = text,
            .kind = ReviewRow::Kind::note,
            .place = place,
            .isHindered = isHindered};
}

bool isOld(const EncoderSession *encoder)
{
    return encoder != nullptr && encoder->freshness().isOld();
}

// The plan is of a moment: it names that at which the encoder was seen last.
std::optional<ReviewRow> ageNote(const Buses &buses, const EncoderSession *encoder)
{
    if (!isOld(encoder))
        return std::nullopt;
    const Freshness &freshness = encoder->freshness();
    const QString when =
        momentText(encoder->dateTime(freshness.seen()), buses.now(encoder->place()).toLocalTime());
    return note(
        encoder->place(),
        TransferLines::tr("Not up to date: %1", "a sentence").arg(lastSeenText(freshness.reason(), when)));
}

// In the column of what is known: how. In the others: what becomes of it.
QStringList tipsOf(const EncoderSession *encoder, const std::optional<Known> &known, const QString &tip)
{
    return {tip, tip, encoder != nullptr ? howKnown(known, *encoder) : tip, tip, tip, tip};
}

bool stores(const DeviceDescription *device, const WriteRow &row)
{
    return device != nullptr && row.step && !row.isOnlyStored && storingSteps({&*row.step, 1}, *device) > 0;
}

// The values are those of the new encoder if it replaces another.
ReviewRow lineOf(const EncoderSession *encoder, const EncoderPlan &plan, const WriteRow &row)
{
    const DeviceDescription *device = plan.newEncoder      ? &*plan.newEncoder
                                      : encoder != nullptr ? &encoder->device()
                                                           : nullptr;
    const QString thereAlready = TransferLines::tr("already there");
    return {.cells = {{},
                      parameterName(device, row.wanted.parameter),
                      transfer_words::known(device, row.wanted.parameter, row.known),
                      transfer_words::value(device, row.wanted),
                      row.isThere ? thereAlready
                      : row.step  ? sentText(*row.step)
                                  : QString(),
                      stores(device, row) ? QStringLiteral("1") : QString()},
            .tips = tipsOf(encoder, row.known,
                           row.hindrance ? refusalText(*row.hindrance)
                           : row.isThere ? TransferLines::tr("The encoder has it: it is left out.")
                           : row.isInStepOfOthers()
                               ? TransferLines::tr("Not wanted: it goes along as it is known, otherwise as "
                                                   "from the factory")
                           : row.goesAlong
                               ? TransferLines::tr("Computed from the other values, and sent after them")
                               : TransferLines::tr("What will be sent for it")),
            .place = plan.place,
            .isThere = row.isThere,
            .isHindered = row.hindrance.has_value(),
            .isOld = isOld(encoder)};
}

ReviewRow lineOf(Place place, const TransferCamRow &row)
{
    return {.cells = {{},
                      TransferLines::tr("Cam program %1").arg(row.wanted.number),
                      row.isThere ? TransferLines::tr("the same")
                      : row.known ? TransferLines::tr("differs")
                                  : TransferLines::tr("unknown"),
                      {},
                      row.isThere ? TransferLines::tr("already there") : QString(),
                      row.isThere ? QString() : QStringLiteral("1")},
            .tip = TransferLines::tr("It is read first, and written where it differs."),
            .place = place,
            .isThere = row.isThere};
}

QString storedText(const DeviceDescription *device, const ProjectDevice &planned, Parameter parameter)
{
    const auto found = std::ranges::find(planned.stored, parameter, &StoredValue::parameter);
    return found == planned.stored.end() ? QString()
                                         : transfer_words::value(device, {parameter, found->value});
}

// "Stored on 1 Mar 2026 14:02: read".
QString howStored(const ProjectDevice &planned, Parameter parameter)
{
    const auto found = std::ranges::find(planned.stored, parameter, &StoredValue::parameter);
    return found == planned.stored.end()
               ? TransferLines::tr("The project has none stored.")
               : TransferLines::tr("As known on %1: %2", "date and time, by hand")
                     .arg(QLocale().toString(found->at.toLocalTime(), QLocale::ShortFormat),
                          known_words::word(found->evidence));
}

QString readingText(const EncoderSession &encoder, const EncoderJobs &jobs)
{
    if (!encoder.can().reads)
        return TransferLines::tr("It cannot be read: what is known of it is stored.");
    const auto &read = std::get<ReadParameters>(jobs.jobs.front());
    return (encoder.can().readingHidesPosition
                ? TransferLines::tr("Values to read: %1. It shows no position meanwhile.")
                : TransferLines::tr("Values to read: %1. It goes on showing its position."))
        .arg(read.parameters.size());
}

void addToStore(std::vector<ReviewRow> &lines, const Buses &buses, const EncoderSession &encoder,
                const ProjectDevice &planned, bool withCams)
{
    const Place place = encoder.place();
    const EncoderJobs jobs = jobsToStore(encoder, withCams);
    const QString reading = readingText(encoder, jobs);
    lines.push_back({.cells = {place.shown(), lineName(encoder.device().fullName(), planned.station)},
                     .tip = reading,
                     .kind = ReviewRow::Kind::head,
                     .place = place,
                     .canBeChosen = !jobs.jobs.empty() || !allKnown(encoder).empty()});
    if (const auto old = ageNote(buses, &encoder))
        lines.push_back(*old);
    lines.push_back(note(place, reading));
    if (withCams && encoder.can().cams)
        lines.push_back(note(place, TransferLines::tr("Its cam programs are read in the cam mode of each. A "
                                                      "program that was changed before is stored when it is "
                                                      "left: one EEPROM write.")));
    for (const Known &known : allKnown(encoder))
        lines.push_back({.cells = {{},
                                   parameterName(&encoder.device(), known.parameter),
                                   transfer_words::known(&encoder.device(), known.parameter, known),
                                   storedText(&encoder.device(), planned, known.parameter)},
                         .tips = {{}, {}, howKnown(known, encoder), howStored(planned, known.parameter)},
                         .place = place,
                         .isOld = isOld(&encoder)});
}

// Nothing is stored for an encoder that may not be the project's.
void addHindered(std::vector<ReviewRow> &lines, const EncoderSession &encoder, const ProjectDevice &planned,
                 const Refusal &why)
{
    lines.push_back(
        {.cells = {encoder.place().shown(), lineName(encoder.device().fullName(), planned.station)},
         .tip = refusalText(why),
         .kind = ReviewRow::Kind::head,
         .place = encoder.place(),
         .isHindered = true});
    lines.push_back(note(encoder.place(), refusalText(why), true));
}

} // namespace

// To the plan's cost, adds that of leaving a changed cam program.
std::vector<EepromWrites> writesOf(const Buses &buses, const TransferPlan &plan)
{
    std::vector<EepromWrites> writes;
    for (const EncoderPlan &one : plan) {
        EncoderSession *encoder = buses.encoder(one.place);
        if (encoder == nullptr)
            continue;
        int ofJobs = 0;
        for (const Job &job : one.jobs)
            ofJobs += mostEepromWrites(*encoder, job);
        writes.push_back({encoder, std::max(one.eepromWrites, ofJobs)});
    }
    return writes;
}

std::vector<ReviewRow> linesOf(const Buses &buses, const TransferPlan &plan)
{
    std::vector<ReviewRow> lines;
    for (const EncoderPlan &encoder : plan) {
        lines.push_back(headOf(encoder));
        const EncoderSession *there = buses.encoder(encoder.place);
        if (const auto old = ageNote(buses, there))
            lines.push_back(*old);
        for (const WriteRow &row : encoder.write.rows)
            lines.push_back(lineOf(there, encoder, row));
        for (const TransferCamRow &row : encoder.cams)
            lines.push_back(lineOf(encoder.place, row));
        if (!encoder.isWritten())
            lines.push_back(
                note(encoder.place, transfer_words::summary(encoder), encoder.hindrance.has_value()));
        for (const QString &text : transfer_words::notes(encoder))
            lines.push_back(note(encoder.place, text));
    }
    return lines;
}

std::vector<ReviewRow> linesToStore(const Buses &buses, const ProjectPlaces &places,
                                    const std::vector<ProjectDevice> &devices, bool withCams)
{
    std::vector<ReviewRow> lines;
    for (const ProjectDevice &device : devices)
        if (const EncoderSession *encoder = buses.encoder(device.place())) {
            if (const auto why = places.hindrance(device.place()))
                addHindered(lines, *encoder, device, *why);
            else
                addToStore(lines, buses, *encoder, device, withCams);
        }
    return lines;
}

} // namespace codewheel
