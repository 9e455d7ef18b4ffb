// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/last_positions.h"

#include "bus/buses.h"
#include "bus/word_channel.h"
#include "catalog/device_description.h"
#include "jobs/protocol.h"
#include "transfer/project_places.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace codewheel {
namespace {

using Since = SeenPosition::Since;
using Scaled = SeenPosition::Scaled;

// What a position is counted in, and from where.
constexpr Parameter scaleParameters[] = {
    Parameter::steps,           Parameter::revolutions, Parameter::direction,    Parameter::coding,
    Parameter::preset,          Parameter::zeroOffset,  Parameter::offset,       Parameter::measuringRange,
    Parameter::measuringLength, Parameter::scaling,     Parameter::scalingFactor};

bool isOfScale(Parameter parameter)
{
    return std::ranges::find(scaleParameters, parameter) != std::end(scaleParameters);
}

ParameterValues knownScale(const EncoderSession &encoder)
{
    ParameterValues scale;
    for (const Parameter parameter : scaleParameters)
        if (const auto known = encoder.known(parameter))
            scale.push_back({parameter, known->value});
    return scale;
}

bool isSetWithThePosition(const ParameterValue &value)
{
    return value.parameter == Parameter::preset || value.parameter == Parameter::zeroOffset ||
           value.parameter == Parameter::offset;
}

ParameterValues withoutZero(ParameterValues scale)
{
    std::erase_if(scale, isSetWithThePosition);
    return scale;
}

ParameterValues onlyZero(ParameterValues scale)
{
    std::erase_if(scale, std::not_fn(isSetWithThePosition));
    return scale;
}

// What is not known of both is not compared.
bool scalesDiffer(const ParameterValues &before, const ParameterValues &now)
{
    return std::ranges::any_of(before, [&](const ParameterValue &value) {
        const auto is = valueOf(now, value.parameter);
        return is && *is != value.value;
    });
}

std::optional<SeenPosition> withScale(std::optional<SeenPosition> seen, const ParameterValues &scale)
{
    if (seen)
        seen->scale = scale;
    return seen;
}

// What was not known before may have been different.
Scaled scaledBy(const ParameterValues &written, const ParameterValues &before)
{
    if (scalesDiffer(before, written))
        return Scaled::otherwise;
    const bool isNew = std::ranges::any_of(written, [&](const ParameterValue &value) {
        return isOfScale(value.parameter) && !valueOf(before, value.parameter);
    });
    return isNew ? Scaled::perhapsOtherwise : Scaled::asThen;
}

// Apart from the values it writes, which are seen when it has ended.
bool mayChangeScale(const DeviceDescription &device, const Job &job)
{
    const auto *send = std::get_if<SendWords>(&job);
    const auto changes = [&](Word word) { return protocolOf(device).mayChangeScale(word); };
    return initialisesPreset(job) || std::holds_alternative<ResetToDefault>(job) ||
           (send != nullptr && std::ranges::any_of(send->words, changes));
}

// Behind a fault of its bus, of which an encoder without a reading says nothing itself.
bool isCutOff(const EncoderBus &bus, const EncoderSession &encoder)
{
    const WordChannel *channel = bus.channel(encoder.place());
    return channel != nullptr && channel->freshness().reason() == Freshness::Reason::notOnBus;
}

// Nothing works there: no word, no answer, or the word of an encoder without power. One that shows no
// position because it is parameterized, in error or in another mode is there.
bool isSeenToBeAway(const EncoderBus &bus, const EncoderSession &encoder)
{
    const Reading &reading = encoder.latest();
    switch (encoder.freshness().reason()) {
    case Freshness::Reason::notOnBus:
    case Freshness::Reason::silent:
        return true;
    case Freshness::Reason::notSeen:
        return bus.isRunning() || isCutOff(bus, encoder);
    case Freshness::Reason::none:
        return encoder.device().hasWords() && reading.state == EncoderState::operation && reading.in == 0 &&
               !reading.velocity && !reading.cams;
    default:
        return false;
    }
}

} // namespace

LastPositions::LastPositions(const Buses &buses, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
{
    connect(&buses, &Buses::updated, this, [this](BusId updated) {
        if (const EncoderBus *bus = m_buses.open(updated); bus != nullptr && !bus->isReplay())
            look(*bus);
    });
    for (const EncoderBus *bus : m_buses.connected())
        look(*bus);
}

// A new one may have shown itself since the first time.
void LastPositions::takeReplaced(Place number)
{
    Watched &its = m_watched[number];
    if (its.isReplaced)
        return;
    keepBefore(its, Since::gone);
    its.earlier.reset();
    its.isReplaced = its.before.has_value();
}

std::optional<SeenPosition> LastPositions::at(Place number) const
{
    const Watched *its = watched(number);
    if (its == nullptr)
        return std::nullopt;
    return its->before ? its->replaced() : withScale(its->last, its->scale);
}

std::optional<SeenPosition> LastPositions::newest(Place number) const
{
    const Watched *its = watched(number);
    if (its == nullptr)
        return std::nullopt;
    return its->last ? withScale(its->last, its->scale) : its->before;
}

SeenPosition LastPositions::kept(Place number, const LastPosition &kept,
                                 const ParameterValues &settings) const
{
    SeenPosition seen{.position = kept.position, .at = kept.at.toLocalTime(), .scale = kept.scale};
    const bool getsTheSame = isOfTheSameScale(kept.scale, settings);
    const ParameterValues compared = getsTheSame ? onlyZero(kept.scale) : kept.scale;
    const auto compare = [&](const ParameterValues &later) {
        if (scalesDiffer(compared, later))
            seen.scaled = Scaled::otherwise;
    };
    if (const EncoderSession *encoder = m_buses.encoder(number))
        compare(knownScale(*encoder));
    const Watched *its = watched(number);
    if (its == nullptr)
        return seen;
    if (its->last && its->last->at >= kept.at)
        compare(its->scale);
    for (const auto &before : {its->earlier, its->before})
        if (before && before->at >= kept.at) {
            compare(before->scale);
            // Of what was written its zero may be a part.
            seen.scaled =
                std::max(seen.scaled,
                         getsTheSame ? std::min(before->scaled, Scaled::perhapsOtherwise) : before->scaled);
        }
    return seen;
}

// With nothing written since, the encoder that went away again may be the new one.
const std::optional<SeenPosition> &LastPositions::Watched::replaced() const
{
    const bool isEarlier = earlier && earlier->scaled == Scaled::asThen &&
                           (earlier->since == Since::gone || before->since == Since::unwatched);
    return isEarlier ? earlier : before;
}

// A simulated encoder says nothing about a real one at its place, nor the other way round.
const LastPositions::Watched *LastPositions::watched(Place number) const
{
    const auto found = m_watched.find(number);
    const EncoderBus *bus = m_buses.busOf(number);
    const bool isOfThisKind =
        found != m_watched.end() && (bus == nullptr || bus->isSimulated() == found->second.isSimulated);
    return isOfThisKind ? &found->second : nullptr;
}

void LastPositions::look(const EncoderBus &bus)
{
    follow(bus);
    const QDateTime now = bus.dateTime(bus.now());
    for (const Place number : bus.places())
        if (const EncoderSession *encoder = bus.encoder(number)) {
            follow(*encoder);
            Watched &its = m_watched[number];
            if (std::exchange(its.isSimulated, bus.isSimulated()) != bus.isSimulated())
                its = {.isSimulated = bus.isSimulated()};
            look(bus, *encoder, now, its);
        }
}

// By the date, since the clock of a bus stands still while the computer sleeps.
void LastPositions::look(const EncoderBus &bus, const EncoderSession &encoder, const QDateTime &now,
                         Watched &watched)
{
    const bool isFirst = !watched.lookedAt.isValid();
    const std::chrono::milliseconds sinceLook{isFirst ? 0 : watched.lookedAt.msecsTo(now)};
    const bool wasWatched = sinceLook.count() >= 0 && sinceLook < untilGone;
    watched.lookedAt = now;
    const std::chrono::milliseconds sinceShown{watched.last ? watched.last->at.msecsTo(now) : 0};
    if (isSeenToBeAway(bus, encoder)) {
        watched.awayFor += wasWatched ? sinceLook : std::chrono::milliseconds{};
        if (watched.awayFor >= untilGone)
            keepBefore(watched, Since::gone);
        return;
    }
    watched.awayFor = {};
    const bool wasUnwatched = !wasWatched || !encoder.freshness().isLive();
    if (!bus.isRunning() || (wasUnwatched && sinceShown >= shortestReplacement))
        keepBefore(watched, Since::unwatched);
    if (!bus.isRunning() || !encoder.freshness().isLive() || !encoder.showsPosition())
        return;
    const Reading &reading = encoder.latest();
    if (watched.before && bus.dateTime(reading.at) <= watched.before->at)
        return; // it is that one
    if (!watched.last)
        comeBack(watched, *reading.position);
    watched.last = SeenPosition{.position = *reading.position, .at = bus.dateTime(reading.at)};
    if (std::exchange(watched.isScaleOld, false))
        watched.scale = knownScale(encoder);
}

// It shows where it was when it went away: another one would hardly do that. That nobody saw it for a while
// is told all the same, unless an earlier time counts.
bool LastPositions::isBack(const Watched &watched, std::int64_t position)
{
    return watched.before && (watched.before->since == Since::gone || watched.earlier) &&
           watched.before->scaled == Scaled::asThen && watched.before->position == position;
}

// Then it was not away, and the loss before that counts.
void LastPositions::comeBack(Watched &watched, std::int64_t position)
{
    if (!watched.isReplaced && isBack(watched, position))
        watched.before = watched.earlier;
    watched.earlier.reset();
}

// An encoder that was seen to be away says more than one that nobody saw.
void LastPositions::keepBefore(Watched &watched, Since since)
{
    const bool isGone = since == Since::gone;
    if (watched.isReplaced)
        return;
    if (watched.last && (isGone || !watched.before || watched.before->since != Since::gone)) {
        watched.earlier = watched.before;
        watched.before = withScale(watched.last, watched.scale);
        watched.before->since = since;
        watched.last.reset();
    } else if (isGone && watched.before) {
        watched.before->since = since; // it went away while nobody saw it
    }
}

void LastPositions::follow(const EncoderBus &bus)
{
    if (!m_followed.insert(&bus).second)
        return;
    connect(&bus, &QObject::destroyed, this, [this, its = &bus] { m_followed.erase(its); });
    connect(&bus, &EncoderBus::writeAboutToBeSent, this,
            [this](const TypedWrite &write) { scaledAnew(write.place, write.values); });
    connect(&bus, &EncoderBus::meetsAgain, this, [this, its = &bus] { meetAgain(*its); });
}

// However short it was, the link was lost, and another encoder may be there now.
void LastPositions::meetAgain(const EncoderBus &bus)
{
    for (const Place place : bus.places())
        if (const auto found = m_watched.find(place); found != m_watched.end())
            keepBefore(found->second, Since::unwatched);
}

void LastPositions::isSame(Place place)
{
    Watched &its = m_watched[place];
    for (auto *before : {&its.earlier, &its.before})
        if (*before && (*before)->since == Since::unwatched)
            before->reset();
}

void LastPositions::isAnother(Place place)
{
    if (auto &before = m_watched[place].before)
        before->since = Since::gone;
}

void LastPositions::follow(const EncoderSession &encoder)
{
    const EncoderSession *its = &encoder;
    if (!m_followed.insert(its).second)
        return;
    m_watched[its->place()].isScaleOld = true;
    connect(its, &QObject::destroyed, this, [this, its] { m_followed.erase(its); });
    connect(its, &EncoderSession::knownChanged, this, [this, its] { compareScale(*its); });
    connect(its, &EncoderSession::isSameAsBefore, this, [this, its] { isSame(its->place()); });
    connect(its, &EncoderSession::isAnotherThanBefore, this, [this, its] { isAnother(its->place()); });
    connect(its, &EncoderSession::jobAboutToStart, this, [this, its](const Job &job) {
        m_watched[its->place()].mayBeScaled = mayChangeScale(its->device(), job);
    });
    connect(its, &EncoderSession::wordAboutToBeSent, this, [this, its](Word word) {
        if (protocolOf(its->device()).mayChangeScale(word))
            scaledAnew(its->place(), Scaled::perhapsOtherwise);
    });
    connect(its, &EncoderSession::finished, this, [this, its](const Outcome &outcome) {
        const bool hasDone = outcome.result || outcome.eepromWrites > 0;
        if (!outcome.written.empty() || outcome.eepromWrites > 0)
            m_watched[its->place()].isReplaced = false;
        const bool isInDoubt = outcome.inDoubt.reset || outcome.inDoubt.position;
        if ((m_watched[its->place()].mayBeScaled && hasDone) || isInDoubt)
            scaledAnew(its->place(), Scaled::perhapsOtherwise);
        for (const ParameterValues *values : {&outcome.written, &outcome.setAlong, &outcome.inDoubt.values})
            scaledAnew(its->place(), *values);
    });
}

void LastPositions::compareScale(const EncoderSession &encoder)
{
    Watched &watched = m_watched[encoder.place()];
    watched.isScaleOld = true;
    for (auto *before : {&watched.earlier, &watched.before})
        if (*before && scalesDiffer((*before)->scale, knownScale(encoder)))
            (*before)->scaled = Scaled::otherwise;
}

void LastPositions::scaledAnew(Place place, Scaled how)
{
    Watched &its = m_watched[place];
    for (auto *before : {&its.earlier, &its.before})
        if (*before)
            (*before)->scaled = std::max((*before)->scaled, how);
}

void LastPositions::scaledAnew(Place place, const ParameterValues &written)
{
    Watched &its = m_watched[place];
    for (auto *before : {&its.earlier, &its.before})
        if (*before)
            (*before)->scaled = std::max((*before)->scaled, scaledBy(written, (*before)->scale));
}

bool isOfAnotherScale(const ParameterValues &then, const ParameterValues &values)
{
    return scalesDiffer(withoutZero(then), values);
}

bool isOfTheSameScale(const ParameterValues &then, const ParameterValues &values)
{
    return isScaleKnown(then) && isScaleKnown(then, values) && isScaleKnown(values, then) &&
           !isOfAnotherScale(then, values);
}

bool isScaleKnown(const ParameterValues &then)
{
    return !withoutZero(then).empty();
}

bool isScaleKnown(const ParameterValues &then, const ParameterValues &values)
{
    return std::ranges::all_of(withoutZero(values), [&](const ParameterValue &value) {
        return !isOfScale(value.parameter) || valueOf(then, value.parameter);
    });
}

std::optional<LastPosition> positionToKeep(const EncoderSession &encoder)
{
    if (!encoder.showsPosition())
        return std::nullopt;
    const Reading &reading = encoder.latest();
    return LastPosition{*reading.position, encoder.dateTime(reading.at).toUTC(), knownScale(encoder)};
}

Project withLastPositions(Project project, const LastPositions &positions, const Buses &buses)
{
    const ProjectPlaces places(project, buses);
    for (ProjectDevice &device : project.devices) {
        if (!places.isTheProjects(device.place()))
            continue;
        if (const auto seen = positions.newest(device.place()))
            device.lastPosition = LastPosition{seen->position, seen->at.toUTC(), seen->scale};
    }
    return project;
}

} // namespace codewheel
