// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "bus/word_channel.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/recording/record_wish.h"
#include "history/track.h"
#include "recording/trigger_text.h"

namespace codewheel {
namespace {

constexpr unsigned bitsOfWord = 16;

tl::unexpected<Complaint> aboutFault(TriggerFault fault, const QString &text)
{
    const auto about = [&](const QString &pattern) { return badInput("badTrigger", pattern, {text}); };
    switch (fault) {
    case TriggerFault::place:
        return about(
            CommandLine::tr("\"%1\" waits for a bit or a value of a bus. Name one of its encoders."));
    case TriggerFault::channel:
        return about(CommandLine::tr("\"%1\" waits for a value that no encoder has. There are position, "
                                     "speed, in, out and cams."));
    case TriggerFault::bit:
        return about(CommandLine::tr("\"%1\" waits for a bit that does not exist. in and out have the bits 0 "
                                     "to 31, cams has 0 to 7."));
    case TriggerFault::number:
        return about(CommandLine::tr("\"%1\" has no number to compare with. A position is a whole number of "
                                     "steps; a speed is in steps per second, with up to three decimals "
                                     "behind a point."));
    case TriggerFault::form:
        break;
    }
    return about(CommandLine::tr("\"%1\" is not a trigger. Write a bit as 1.0/in.25 (becomes 1) or "
                                 "1.0/in.25=0, a threshold in quotation marks as \"1.0/position>1000\", "
                                 "or a message as fault or 1.0/fault."));
}

// The other kinds of trigger can happen at any encoder.
bool canHappen(const Call &call, const BitTrigger &trigger)
{
    if (trigger.channel == Channel::cams)
        return call.buses.encoder(trigger.place)->can().cams.has_value();
    const WordChannel *words = call.buses.channel(trigger.place);
    if (words == nullptr)
        return false;
    const int count = trigger.channel == Channel::in ? words->inWords() : words->outWords();
    return trigger.bit < static_cast<unsigned>(count) * bitsOfWord;
}

Checked<RecordingTrigger> checkBit(const Call &call, const RecordingTrigger &trigger)
{
    const auto *bit = std::get_if<BitTrigger>(&trigger);
    if (bit == nullptr || canHappen(call, *bit))
        return trigger;
    const QString what = channelKey(bit->channel) + u'.' + QString::number(bit->bit);
    return badInput("noSuchBit", CommandLine::tr("The encoder at %1 has no %2."), {bit->place.shown(), what});
}

// An encoder comes before a bus of the same name.
Checked<Place> triggerPlaceMeant(const Call &call, const QString &typed)
{
    if (const auto bus = triggerPlace(typed); bus && bus->isEmpty() && call.findBus(bus->bus) != nullptr)
        return *bus;
    auto place = placeMeant(call, call.project, typed);
    if (place)
        return encoderAt(call, typed).map([](const EncoderSession *encoder) { return encoder->place(); });
    if (const auto bus = busNamed(call, typed))
        return (*bus)->bus().placeOf({});
    return place;
}

} // namespace

Checked<RecordingTrigger> triggerMeant(const Call &call, const QString &text)
{
    std::optional<Complaint> noPlace;
    const auto placeOf = [&](const QString &typed) {
        const auto place = triggerPlaceMeant(call, typed);
        if (!place)
            noPlace = place.error();
        return place ? std::optional(*place) : std::nullopt;
    };
    const auto trigger = parseTrigger(text, placeOf);
    if (noPlace)
        return tl::unexpected(*noPlace);
    if (!trigger)
        return aboutFault(trigger.error(), text);
    return checkBit(call, *trigger);
}

} // namespace codewheel
