// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/places.h"

#include "bus/encoder_bus.h"
#include "catalog/label_key.h"
#include "cli/bus_access.h"
#include "cli/device_text.h"
#include "cli/link_kind.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
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

// Of all buses of the project, or of this one.
std::vector<Place> placesAt(const Project *project, const QString &station, std::optional<BusId> bus)
{
    std::vector<Place> places;
    if (project != nullptr)
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

QString list(const Call &call, const std::vector<Place> &places)
{
    QStringList texts;
    for (const Place place : places)
        texts << named(call, place);
    return texts.join(QStringLiteral(", "));
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
    return badInput(QStringLiteral("placeNotUnique"),
                    CommandLine::tr("Several buses may have %1. Give one of these: %2."),
                    {typed, list(call, likely.empty() ? places : likely)});
}

Checked<Place> atStation(const Call &call, const Project &project, const std::vector<Place> &places,
                         const QString &station)
{
    if (places.size() > 1)
        return badInput(QStringLiteral("stationNotUnique"),
                        CommandLine::tr("The project has several devices at the station \"%1\": %2. Give the "
                                        "device number."),
                        {station, list(call, places)});
    const Place place = places.front();
    const BusAccess *bus = call.findBus(place.bus);
    if (bus == nullptr)
        return badInput(QStringLiteral("stationOnBus"),
                        CommandLine::tr("\"%1\" is a station on a bus that the link does not lead to."),
                        {station});
    return bus->checkStation(project, station).map([&] { return place; });
}

// Of a kind that the link has no bus of.
const LinkKind *kindOfPlace(const QString &typed)
{
    for (const LinkKind *kind : linkKinds())
        if (kind->isPlace(typed))
            return kind;
    return nullptr;
}

tl::unexpected<Complaint> notThere(const std::vector<BusAccess *> &buses, bool hasProject,
                                   const QString &typed)
{
    if (const LinkKind *kind = kindOfPlace(typed))
        return badInput(
            QStringLiteral("placeOnBus"),
            CommandLine::tr("%1 is a place on a bus that the link does not lead to (%2). Places there "
                            "are: %3."),
            {typed, busKind(kind->bus())->title(), buses.front()->somePlaces()});
    if (hasProject)
        return badInput(QStringLiteral("unknownStation"),
                        CommandLine::tr("\"%1\" is neither a device number nor a station of the project."),
                        {typed});
    const auto meant = std::ranges::find_if(buses, [&](const BusAccess *bus) { return bus->isMeant(typed); });
    return tl::unexpected((meant == buses.end() ? buses.front() : *meant)->notAPlace(typed));
}

QString busNames(const Call &call)
{
    QStringList names;
    for (const BusAccess *bus : call.links)
        names << bus->name();
    return names.join(QStringLiteral(", "));
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
    return notThere(buses, project != nullptr, typed);
}

// By its name, else by its number.
BusAccess *findBus(const Call &call, const QString &name)
{
    const auto found = std::ranges::find(call.links, name, &BusAccess::name);
    return found == call.links.end() ? call.findBus({name.toInt()}) : *found;
}

tl::unexpected<Complaint> noSuchBus(const Call &call, const QString &name)
{
    return badInput(QStringLiteral("unknownBus"),
                    CommandLine::tr("The link leads to no bus \"%1\". The buses are: %2."),
                    {name, busNames(call)});
}

Checked<EncoderSession *> encoderMeant(const Call &call, const QString &typed, bool namesIt)
{
    const auto place = placeMeant(call, call.project, typed);
    if (!place)
        return tl::unexpected(place.error());
    BusAccess &bus = call.busOf(*place);
    if (const auto why = bus.whyNot(call.command))
        return tl::unexpected(*why);
    return bus.encoder(call, place->node, namesIt);
}

} // namespace

Checked<Place> placeMeant(const Call &call, const Project *project, const QString &typed)
{
    const qsizetype slash = typed.lastIndexOf(u'/');
    if (slash < 0 || !placesAt(project, typed, {}).empty())
        return placeOn(call, call.links, project, typed);
    BusAccess *bus = findBus(call, typed.first(slash));
    if (bus == nullptr)
        return noSuchBus(call, typed.first(slash));
    return placeOn(call, {bus}, project, typed.sliced(slash + 1));
}

Checked<EncoderSession *> encoderAt(const Call &call)
{
    return encoderMeant(call, call.arguments.rest.front(), true);
}

Checked<EncoderSession *> encoderAt(const Call &call, const QString &typed)
{
    return encoderMeant(call, typed, false);
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

Checked<BusAccess *> busMeant(const Call &call, const QString &kind)
{
    if (const auto name = call.arguments.value("--bus")) {
        BusAccess *bus = findBus(call, *name);
        return bus != nullptr && bus->kind() == kind ? Checked<BusAccess *>(bus) : noSuchBus(call, *name);
    }
    std::vector<BusAccess *> buses;
    std::ranges::copy_if(call.links, std::back_inserter(buses),
                         [&](const BusAccess *bus) { return bus->kind() == kind; });
    if (buses.size() == 1)
        return buses.front();
    if (buses.empty())
        return badInput(QStringLiteral("noSuchBus"),
                        CommandLine::tr("The link leads to no bus of this kind: %1."),
                        {busKind(kind)->title()});
    return badInput(QStringLiteral("busNotUnique"),
                    CommandLine::tr("The link leads to several buses. Name one with --bus: %1."),
                    {busNames(call)});
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

} // namespace codewheel
