// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_access.h"

#include "bus/buses.h"
#include "bus/word_channel.h"
#include "catalog/label_key.h"
#include "cli/device_text.h"
#include "cli/line_encoders.h"
#include "cli/project_access.h"
#include "cli/subcommand.h"
#include "cli/texts.h"
#include "cli/trace.h"
#include "ring/bus_session.h"

#include <algorithm>

namespace codewheel {
namespace {

QString placesOf(const BusSession &bus)
{
    QStringList places;
    for (const Place number : bus.places())
        places << number.toString();
    return places.join(QStringLiteral(", "));
}

Checked<void> nameDevice(const Call &call, Place number, const QString &typed)
{
    if (call.bus->channel(number) == nullptr)
        return {};
    const auto meant = deviceMeant(call, number, typed);
    if (!meant)
        return tl::unexpected(meant.error());
    const DeviceDescription *device = call.catalog.find(meant->key);
    if (device != nullptr && device->profile == Profile::esc)
        return badInput(QStringLiteral("deviceOnSerialLine"),
                        CommandLine::tr("The %1 is on a serial line, not on INTERBUS: it cannot be the "
                                        "device at %2."),
                        {device->fullName(), number.toString()});
    if (const auto named = call.bus->name(number, meant->key, meant->turns, meant->stepsPerTurn); !named)
        return tl::unexpected(complaintAbout(named.error()));
    return {};
}

} // namespace

Checked<NamedDevice> deviceMeant(const Call &call, Place place, const QString &typed)
{
    if (call.catalog.find(typed))
        return NamedDevice{typed};
    const auto matches = findByLabel(call.catalog, typed);
    if (!matches)
        return tl::unexpected(deviceNamed(call.catalog, typed).error());
    const EncoderBus *bus = call.buses.busOf(place);
    const auto found = std::ranges::find_if(*matches, [&](const LabelMatch &match) {
        return bus && bus->canBe(place, *match.device).has_value();
    });
    const LabelMatch &match = found == matches->end() ? matches->front() : *found;
    return NamedDevice{match.device->key, match.turns, match.stepsPerTurn};
}

Checked<EncoderSession *> encoderMeant(const Call &call)
{
    return placeMeant(call, call.arguments.rest.front()).and_then([&](const QString &place) {
        return isOnLine(call, place) ? encoderOnLine(call, place) : encoderAt(*call.bus, place);
    });
}

Checked<EncoderSession *> encoderAt(const Call &call)
{
    const auto place = placeMeant(call, call.arguments.rest.front());
    if (!place)
        return tl::unexpected(place.error());
    if (isOnLine(call, *place))
        return encoderOnLine(call, *place);
    const auto number = Place::parse(*place);
    const auto device = call.arguments.value("--device");
    if (number && device)
        if (const auto named = nameDevice(call, *number, *device); !named)
            return tl::unexpected(named.error());
    return encoderAt(*call.bus, *place);
}

Checked<EncoderSession *> encoderAt(BusSession &bus, const QString &place)
{
    const auto number = Place::parse(place);
    if (!number || !bus.channel(*number))
        return tl::unexpected(
            complaintAbout({RefusalKind::badInput, RefusalId::unknownDevice, {place, placesOf(bus)}}));
    EncoderSession *encoder = bus.encoder(*number);
    if (!encoder)
        return badInput(QStringLiteral("noEncoder"),
                        CommandLine::tr("The device at %1 is no encoder this program can drive. See "
                                        "codewheel-cli scan."),
                        {place});
    if (encoder->latest().state == EncoderState::notSeen)
        bus.advance(1);
    return encoder;
}

Exchange currentRow(const BusSession &bus, const EncoderSession &encoder)
{
    const WordChannel &channel = *bus.channel(encoder.place());
    const Reading &reading = encoder.latest();
    return {bus.latest().cycle, bus.latest().at, channel.out(), channel.in(), reading.mode, reading.coding};
}

FinishedJob runToEnd(const Call &call, const AllowedJob &allowed)
{
    EncoderSession &encoder = allowed.encoder();
    if (encoder.place().isOnLine())
        return runOnLine(*call.line, allowed);
    BusSession &bus = *call.bus;
    FinishedJob finished;
    finished.rows.push_back(currentRow(bus, encoder));
    const auto started = encoder.start(allowed.job());
    if (!started) {
        finished.outcome.result = tl::unexpected(started.error());
        return finished;
    }

    bool running = true;
    QObject scope;
    QObject::connect(&encoder, &EncoderSession::exchanged, &scope,
                     [&](const Exchange &row) { finished.rows.push_back(row); });
    QObject::connect(&encoder, &EncoderSession::finished, &scope, [&](const Outcome &outcome) {
        running = outcome.job != *started;
        finished.outcome = outcome;
    });
    while (running)
        bus.advance(1);
    return finished;
}

bool isOfLine(const Call &call, Place place)
{
    return call.line != nullptr && call.line->bus().id() == place.bus;
}

Complaint complaintAboutJob(const Call &call, Place place, const Refusal &why)
{
    return isOfLine(call, place) ? call.line->complaint(why) : complaintAbout(why);
}

void passTime(const Call &call, Place place)
{
    if (isOfLine(call, place))
        call.line->advance(LineAccess::lookInterval);
    else
        call.bus->advance(1);
}

LedgerKeeper *ledgerOf(const Call &call, Place place)
{
    return isOfLine(call, place) ? call.line->ledger() : call.ledger;
}

QString traceText(const Call &call, const EncoderSession &encoder, const FinishedJob &job)
{
    if (encoder.place().isOnLine())
        return lineTraceText(job.passed, call.line->explainOptions());
    return traceText(encoder.device(), job.rows);
}

QJsonArray traceJson(const Call &call, const EncoderSession &encoder, const FinishedJob &job)
{
    if (encoder.place().isOnLine())
        return lineTraceJson(job.passed, call.line->explainOptions());
    return traceJson(encoder.device(), job.rows);
}

} // namespace codewheel
