// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_lines.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "drivers/values_to_write.h"
#include "drivers/write_plan.h"
#include "encoder/refusal_text.h"
#include "transfer/project_places.h"
#include "transfer/transfer_words.h"
#include "transfer/value_store.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct TransferLines
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TransferLines)
};

const DeviceDescription *deviceAt(const Buses &buses, Place place)
{
    const EncoderSession *encoder = buses.encoder(place);
    return encoder ? &encoder->device() : nullptr;
}

QString lineName(const QString &device, const QString &station)
{
    const QString name = device.isEmpty() ? TransferLines::tr("not there") : device;
    return station.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, station);
}

TransferLine headOf(const EncoderPlan &plan)
{
    return {.place = plan.place,
            .what = lineName(plan.device, plan.station),
            .eeprom = plan.isWritten() ? QString::number(plan.eepromWrites) : QString(),
            .tip = transfer_words::summary(plan),
            .canBeChosen = plan.isWritten(),
            .isThere = !plan.hindrance && plan.jobs.empty(),
            .isHindered = plan.hindrance.has_value()};
}

TransferLine lineOf(const DeviceDescription *device, Place place, const TransferRow &row)
{
    const QString thereAlready = TransferLines::tr("already there");
    return {.kind = TransferLine::Kind::value,
            .place = place,
            .what = parameterName(row.wanted.parameter),
            .now = transfer_words::known(device, row.wanted.parameter, row.known),
            .wanted = transfer_words::value(device, row.wanted),
            .sent = row.isThere ? thereAlready
                    : row.step  ? sentText(*row.step)
                                : QString(),
            .eeprom = row.step ? QStringLiteral("1") : QString(),
            .tip = row.hindrance ? refusalText(*row.hindrance)
                   : row.isThere ? TransferLines::tr("The encoder has it: it is left out.")
                   : row.goesAlong
                       ? TransferLines::tr("Computed from the other values, which act once it is sent")
                       : TransferLines::tr("What will be sent for it"),
            .isThere = row.isThere,
            .isHindered = row.hindrance.has_value()};
}

TransferLine lineOf(Place place, const TransferCamRow &row)
{
    return {.kind = TransferLine::Kind::value,
            .place = place,
            .what = TransferLines::tr("Cam program %1").arg(row.wanted.number),
            .now = row.isThere ? TransferLines::tr("the same")
                   : row.known ? TransferLines::tr("another")
                               : TransferLines::tr("unknown"),
            .sent = row.isThere ? TransferLines::tr("already there") : QString(),
            .eeprom = row.isThere ? QString() : QStringLiteral("1"),
            .tip = TransferLines::tr("It is read first, and written where it differs."),
            .isThere = row.isThere};
}

TransferLine note(Place place, const QString &text, bool isHindered = false)
{
    return {.kind = TransferLine::Kind::note,
            .place = place,
            .what = text,
            .tip = text,
            .isHindered = isHindered};
}

QString storedText(const DeviceDescription *device, const ProjectDevice &planned, Parameter parameter)
{
    const auto found = std::ranges::find(planned.stored, parameter, &StoredValue::parameter);
    return found == planned.stored.end() ? QString()
                                         : transfer_words::value(device, {parameter, found->value});
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

void addToStore(std::vector<TransferLine> &lines, const EncoderSession &encoder, const ProjectDevice &planned,
                bool withCams)
{
    const Place place = encoder.place();
    const EncoderJobs jobs = jobsToStore(encoder, withCams);
    const QString reading = readingText(encoder, jobs);
    lines.push_back({.place = place,
                     .what = lineName(encoder.device().fullName(), planned.station),
                     .tip = reading,
                     .canBeChosen = !jobs.jobs.empty() || !allKnown(encoder).empty()});
    lines.push_back(note(place, reading));
    if (withCams && encoder.can().cams)
        lines.push_back(note(place, TransferLines::tr("Its cam programs are read in the cam mode of each. A "
                                                      "program that was changed before is stored when it is "
                                                      "left: one EEPROM write.")));
    for (const Known &known : allKnown(encoder))
        lines.push_back({.kind = TransferLine::Kind::value,
                         .place = place,
                         .what = parameterName(known.parameter),
                         .now = transfer_words::known(&encoder.device(), known.parameter, known),
                         .wanted = storedText(&encoder.device(), planned, known.parameter),
                         .tip = TransferLines::tr("Known now, beside what the project has stored")});
}

// Nothing is stored of an encoder that may be another than the project's.
void addHindered(std::vector<TransferLine> &lines, const EncoderSession &encoder,
                 const ProjectDevice &planned, const Refusal &why)
{
    lines.push_back({.place = encoder.place(),
                     .what = lineName(encoder.device().fullName(), planned.station),
                     .tip = refusalText(why),
                     .isHindered = true});
    lines.push_back(note(encoder.place(), refusalText(why), true));
}

} // namespace

std::vector<TransferLine> linesOf(const Buses &buses, const TransferPlan &plan)
{
    std::vector<TransferLine> lines;
    for (const EncoderPlan &encoder : plan) {
        lines.push_back(headOf(encoder));
        const DeviceDescription *device = deviceAt(buses, encoder.place);
        for (const TransferRow &row : encoder.rows)
            lines.push_back(lineOf(device, encoder.place, row));
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

std::vector<TransferLine> linesToStore(const Buses &buses, const ProjectPlaces &places,
                                       const std::vector<ProjectDevice> &devices, bool withCams)
{
    std::vector<TransferLine> lines;
    for (const ProjectDevice &device : devices)
        if (const EncoderSession *encoder = buses.encoder(device.place())) {
            if (const auto why = places.hindrance(device.place()))
                addHindered(lines, *encoder, device, *why);
            else
                addToStore(lines, *encoder, device, withCams);
        }
    return lines;
}

} // namespace codewheel
