// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"

#include "bus/encoder_bus.h"
#include "catalog/catalog.h"
#include "catalog/device_description.h"
#include "catalog/label_key.h"
#include "cli/bus/bus_access.h"
#include "cli/call/texts.h"
#include "cli/encoder/parameter_arguments.h"
#include "cli/kinds/link_kind.h"
#include "project/bus_kind.h"

#include <algorithm>

namespace codewheel {
namespace {

enum class Form { full, any }; // as the bus writes it, or as it may be typed

std::vector<Place> placesOn(const std::vector<BusAccess *> &buses, const QString &typed, Form form)
{
    std::vector<Place> places;
    for (const BusAccess *bus : buses)
        if (const auto node = bus->placeTyped(typed);
            node && (form == Form::any || node->toString() == typed))
            places.push_back(bus->bus().placeOf(*node));
    return places;
}

// On all buses of the project, or on this one.
std::vector<Place> placesAt(const Project *project, const QString &station, std::optional<BusId> bus)
{
    std::vector<Place> places;
    if (project != nullptr && !station.isEmpty())
        for (const ProjectDevice &device : project->devices)
            if (device.station == station && (!bus || device.bus == *bus))
                places.push_back(device.place());
    return places;
}

QString named(const Call &call, Place place)
{
    const BusAccess *bus = call.findBus(place.bus);
    return bus != nullptr && call.links.size() > 1
               ? QStringLiteral("%1/%2").arg(bus->name(), place.toString())
               : place.toString();
}

// With the numbers of their buses.
QString numbers(const std::vector<Place> &places)
{
    return listed(places, [](Place place) {
        return QStringLiteral("%1/%2").arg(place.bus.number).arg(place.toString());
    });
}

QString list(const Call &call, const std::vector<Place> &places)
{
    return listed(places, [&](Place place) { return named(call, place); });
}

// For a place that none of several buses has.
Complaint onNone(const Call &call, const std::vector<Place> &places, const QString &typed)
{
    std::vector<Place> there;
    for (const Place place : places)
        std::ranges::copy(call.busOf(place).knownPlaces(), std::back_inserter(there));
    return complaintAbout({RefusalKind::badInput, RefusalId::unknownDevice, {typed, list(call, there)}});
}

Checked<Place> onlyOne(const Call &call, const std::vector<Place> &places, const QString &typed)
{
    std::vector<Place> likely;
    std::ranges::copy_if(places, std::back_inserter(likely),
                         [&](Place place) { return call.busOf(place).mayHave(place.node); });
    if (likely.size() == 1)
        return likely.front();
    if (places.size() == 1)
        return places.front();
    const bool isKnown =
        std::ranges::all_of(places, [&](Place place) { return call.busOf(place).knowsItsPlaces(); });
    if (likely.empty() && isKnown)
        return tl::unexpected(onNone(call, places, typed));
    return badInput("placeNotUnique", CommandLine::tr("Several buses may have %1. Give one of these: %2."),
                    {typed, list(call, likely.empty() ? places : likely)});
}

Checked<Place> atStation(const Call &call, const Project &project, const std::vector<Place> &places,
                         const QString &station)
{
    if (places.size() > 1)
        return badInput("stationNotUnique",
                        CommandLine::tr("The project has several devices at the station \"%1\". Give one of "
                                        "these: %2."),
                        {station, list(call, places)});
    const Place place = places.front();
    const BusAccess *bus = call.findBus(place.bus);
    if (bus == nullptr)
        return badInput("stationOnBus",
                        CommandLine::tr("\"%1\" is a station on a bus that the link does not lead to."),
                        {station});
    return bus->checkStation(project, station).map([&] { return place; });
}

// A kind of which the link has no bus.
const LinkKind *kindOfPlace(const QString &typed)
{
    for (const LinkKind *kind : linkKinds())
        if (kind->isPlace(typed))
            return kind;
    return nullptr;
}

tl::unexpected<Complaint> notThere(const Call &call, const std::vector<BusAccess *> &buses, bool hasProject,
                                   const QString &typed)
{
    const LinkKind *kind = kindOfPlace(typed);
    const auto isOfKind = [kind](const BusAccess *bus) { return bus->kind() == kind->bus(); };
    if (kind != nullptr && std::ranges::none_of(call.links, isOfKind))
        return badInput(
            "placeOnBus",
            CommandLine::tr("%1 is a place on a bus that the link does not lead to (%2). Places there "
                            "are: %3."),
            {typed, busKind(kind->bus())->title(), buses.front()->somePlaces()});
    if (kind != nullptr && buses.size() < call.links.size()) // of the bus that was named
        return tl::unexpected(buses.front()->notAPlace(typed));
    const auto meant = std::ranges::find_if(buses, [&](const BusAccess *bus) { return bus->isMeant(typed); });
    if (hasProject && meant == buses.end())
        return badInput("unknownStation",
                        CommandLine::tr("\"%1\" is neither a device number nor a station of the project."),
                        {typed});
    return tl::unexpected((meant == buses.end() ? buses.front() : *meant)->notAPlace(typed));
}

Checked<Place> placeOn(const Call &call, const std::vector<BusAccess *> &buses, const Project *project,
                       const QString &typed)
{
    if (const auto places = placesOn(buses, typed, Form::full); !places.empty())
        return onlyOne(call, places, typed);
    const auto bus =
        buses.size() == 1 && call.links.size() > 1 ? std::optional(buses.front()->bus().id()) : std::nullopt;
    if (const auto places = placesAt(project, typed, bus); !places.empty())
        return atStation(call, *project, places, typed);
    if (const auto places = placesOn(buses, typed, Form::any); !places.empty())
        return onlyOne(call, places, typed);
    return notThere(call, buses, project != nullptr, typed);
}

bool isInProject(const Call &call, const QString &name)
{
    return call.project != nullptr && std::ranges::count(call.project->buses, name, &PlannedBus::name) > 0;
}

tl::unexpected<Complaint> noSuchBus(const Call &call, const QString &name)
{
    if (isInProject(call, name))
        return badInput(
            "unknownBus",
            CommandLine::tr("The project has the bus \"%1\", but the link does not lead to it. The "
                            "buses of the link are: %2. --link project leads to all of the "
                            "project."),
            {name, listed(call.links, &BusAccess::name)});
    return badInput("unknownBus", CommandLine::tr("The link leads to no bus \"%1\". The buses are: %2."),
                    {name, listed(call.links, &BusAccess::name)});
}

// The one of these buses of one kind that the option names.
Checked<BusAccess *> oneOf(const Call &call, const std::vector<BusAccess *> &buses, const Option &option)
{
    const auto name = call.arguments.value(option.name);
    if (!name && buses.size() == 1)
        return buses.front();
    if (!name)
        return badInput("busNotUnique",
                        CommandLine::tr("The link leads to several buses. Name one with %1: %2."),
                        {QString::fromLatin1(option.name), listed(buses, &BusAccess::name)});
    auto bus = busNamed(call, *name);
    if (!bus || std::ranges::count(buses, *bus) > 0)
        return bus;
    return badInput("noSuchBus", CommandLine::tr("\"%1\" is not a bus of this kind: %2. There is: %3."),
                    {*name, busKind(buses.front()->kind())->title(), listed(buses, &BusAccess::name)});
}

// Why it is not the encoder that the project has there; --device says what to take it for.
std::optional<Refusal> whyOther(const Call &call, Place place)
{
    const ProjectDevice *planned = call.project != nullptr ? findDevice(*call.project, place) : nullptr;
    if (planned == nullptr)
        return std::nullopt;
    const EncoderBus &bus = call.busOf(place).bus();
    const EncoderSession *encoder = bus.encoder(place);
    return bus.isOther(place, encoder != nullptr ? encoder->device().key : QString(),
                       planned->label.serialNumber);
}

Checked<EncoderSession *> encoderMeant(const Call &call, const QString &typed, bool namesIt)
{
    const auto place = placeMeant(call, call.project, typed);
    if (!place)
        return tl::unexpected(place.error());
    BusAccess &bus = call.busOf(*place);
    if (const auto why = bus.whyNot(call.command))
        return tl::unexpected(*why);
    auto encoder = bus.encoder(call, place->node, namesIt);
    if (const auto other = encoder && namesIt ? whyOther(call, *place) : std::nullopt)
        return tl::unexpected(complaintAbout(*other));
    return encoder;
}

} // namespace

Checked<BusAccess *> busNamed(const Call &call, const QString &name)
{
    const auto found = std::ranges::find(call.links, name, &BusAccess::name);
    const int number = name.toInt();
    BusAccess *numbered = QString::number(number) == name ? call.findBus({number}) : nullptr;
    BusAccess *named = found == call.links.end() ? numbered : *found;
    if (named == nullptr)
        return noSuchBus(call, name);
    if (numbered == nullptr || numbered == named)
        return named;
    return badInput("busNotUnique",
                    CommandLine::tr("\"%1\" is the name of one bus and the number of another. Rename it."),
                    {name});
}

// A text that is both a station as it is and a place after the name of a bus counts as neither.
Checked<Place> placeMeant(const Call &call, const Project *project, const QString &typed)
{
    const qsizetype slash = typed.indexOf(u'/');
    if (slash < 0)
        return placeOn(call, call.links, project, typed);
    auto onBus = busNamed(call, typed.first(slash)).and_then([&](BusAccess *bus) {
        return placeOn(call, {bus}, project, typed.sliced(slash + 1));
    });
    std::vector<Place> stations = placesAt(project, typed, {});
    if (stations.empty())
        return onBus;
    if (!onBus)
        return atStation(call, *project, stations, typed);
    stations.push_back(*onBus);
    return badInput(
        "placeNotUnique",
        CommandLine::tr("\"%1\" is a station of the project, and a place on a bus. Give the number "
                        "of the bus and the place: %2."),
        {typed, numbers(stations)});
}

Checked<EncoderSession *> encoderAt(const Call &call)
{
    return encoderMeant(call, call.arguments.rest.front(), true);
}

Checked<EncoderSession *> encoderAt(const Call &call, const QString &typed)
{
    return encoderMeant(call, typed, false);
}

Checked<std::set<Place>> encodersAt(const Call &call)
{
    std::set<Place> places;
    for (const QString &typed : call.arguments.rest) {
        const auto encoder = encoderMeant(call, typed, true);
        if (!encoder)
            return tl::unexpected(encoder.error());
        places.insert((*encoder)->place());
    }
    return places;
}

Checked<NamedDevice> deviceMeant(const Call &call, Place place, const QString &typed)
{
    if (call.catalog.find(typed) != nullptr)
        return NamedDevice{typed};
    const auto matches = findByLabel(call.catalog, typed);
    if (!matches)
        return tl::unexpected(deviceNamed(call.catalog, typed).error());
    const EncoderBus &bus = call.busOf(place).bus();
    const auto found = std::ranges::find_if(
        *matches, [&](const LabelMatch &match) { return bus.canBe(place, *match.device).has_value(); });
    const LabelMatch &match = found == matches->end() ? matches->front() : *found;
    return NamedDevice{match.device->key, match.turns, match.stepsPerTurn};
}

Checked<void> nameDevice(const Call &call, Place place)
{
    const auto typed = call.arguments.value("--device");
    if (!typed)
        return {};
    const auto meant = deviceMeant(call, place, *typed);
    if (!meant)
        return tl::unexpected(meant.error());
    if (const auto named = call.busOf(place).bus().name(place, meant->key, meant->turns, meant->stepsPerTurn);
        !named)
        return tl::unexpected(complaintAbout(named.error()));
    return {};
}

std::vector<BusAccess *> busesOf(const Call &call, const QString &kind)
{
    std::vector<BusAccess *> buses;
    std::ranges::copy_if(call.links, std::back_inserter(buses),
                         [&](const BusAccess *bus) { return bus->kind() == kind; });
    return buses;
}

Checked<BusAccess *> busMeant(const Call &call, const QString &kind)
{
    const std::vector<BusAccess *> buses = busesOf(call, kind);
    if (buses.empty())
        return badInput("noSuchBus", CommandLine::tr("The link leads to no bus of this kind: %1."),
                        {busKind(kind)->title()});
    return oneOf(call, buses, busOption);
}

Checked<BusAccess *> ringOfFaults(const Call &call)
{
    std::vector<BusAccess *> rings;
    std::ranges::copy_if(call.links, std::back_inserter(rings), &BusAccess::followsFaultPlan);
    if (rings.empty())
        return badInput(
            "faultPlanOnLine",
            CommandLine::tr("A fault plan is for the ring of the training bus. Leave --fault-plan "
                            "out."));
    return oneOf(call, rings, faultBusOption);
}

QJsonObject placeJson(const Call &call, Place place, QJsonObject more)
{
    addPlace(more, call, place);
    return more;
}

void addPlace(QJsonObject &json, const Call &call, Place place)
{
    if (const BusAccess *bus = call.findBus(place.bus))
        json.insert(QStringLiteral("busName"), bus->name());
    json.insert(QStringLiteral("bus"), place.bus.number);
    json.insert(QStringLiteral("place"), place.toString());
}

void addBus(QJsonObject &json, const BusAccess &bus)
{
    json.insert(QStringLiteral("busName"), bus.name());
    json.insert(QStringLiteral("bus"), bus.bus().id().number);
}

} // namespace codewheel
