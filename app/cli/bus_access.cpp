// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_access.h"

#include "cli/texts.h"
#include "ring/bus_session.h"
#include "ring/word_channel.h"

namespace codewheel {
namespace {

QString placesOf(const BusSession &bus)
{
    QStringList places;
    for (const DeviceNumber number : bus.numbers())
        places << number.toString();
    return places.join(QStringLiteral(", "));
}

} // namespace

Checked<EncoderSession *> encoderAt(BusSession &bus, const QString &place)
{
    const auto number = DeviceNumber::parse(place);
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
    const WordChannel &channel = *bus.channel(encoder.number());
    const Reading &reading = encoder.latest();
    return {bus.latest().cycle, bus.latest().at, channel.out(), channel.in(), reading.mode, reading.coding};
}

FinishedJob runToEnd(BusSession &bus, EncoderSession &encoder, const Job &job)
{
    FinishedJob finished;
    finished.rows.push_back(currentRow(bus, encoder));
    const auto started = encoder.start(job);
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

} // namespace codewheel
