// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/project_access.h"

#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "cli/line_encoders.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
#include "journal/ledger_keeper.h"
#include "project/project_file.h"
#include "project/project_take_over.h"
#include "ring/bus_session.h"
#include "transfer/project_places.h"

#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

// A name given anew would forget what is known of the encoder.
bool isNamedSo(const Participant &connected, const DeviceDescription &device, const DeviceLabel &label)
{
    return connected.deviceKey == device.key && (label.turns == 0 || label.turns == device.physicalTurns) &&
           (label.stepsPerTurn == 0 || label.stepsPerTurn == device.physicalStepsPerTurn);
}

void nameDevice(const Call &call, const ProjectDevice &planned, const Participant &connected)
{
    const QString &key = planned.participant.deviceKey;
    const DeviceDescription *device = call.catalog.find(key);
    if (device != nullptr && isNamedSo(connected, *device, planned.label))
        return;
    if (device != nullptr && device->deviceCode == connected.deviceCode &&
        call.bus->name(planned.place(), key, planned.label.turns, planned.label.stepsPerTurn))
        return;
    call.terminal.complain(
        sentence(CommandLine::tr("%1 is not taken for \"%2\" of the project: there is no such description, "
                                 "or it is of another device code."),
                 {connected.number.toString(), key}));
}

Checked<void> checkSameDevice(const Call &call, Place number)
{
    const ProjectDevice *planned = findDevice(*call.project, number);
    const auto &ring = call.bus->structure();
    const auto connected = std::ranges::find(ring, number.node, &Participant::number);
    if (!planned || connected == ring.end() || isSameKind(planned->participant, *connected))
        return {};
    return tl::unexpected(complaintAbout({RefusalKind::link,
                                          RefusalId::ringDiffers,
                                          {number.toString(), hexCode(planned->participant.deviceCode, 4),
                                           hexCode(connected->deviceCode, 4)}}));
}

// Of all buses.
std::vector<Place> placesAt(const Project &project, const QString &station)
{
    std::vector<Place> places;
    for (const ProjectDevice &device : project.devices)
        if (device.station == station)
            places.push_back(device.place());
    return places;
}

} // namespace

Checked<Place> placeOfStation(const Call &call, const Project &project, const QString &station)
{
    const std::vector<Place> places = placesAt(project, station);
    QStringList texts;
    for (const Place place : places)
        texts << place.toString();
    if (places.empty())
        return badInput(QStringLiteral("unknownStation"),
                        CommandLine::tr("\"%1\" is neither a device number nor a station of the project."),
                        {station});
    if (places.size() > 1)
        return badInput(QStringLiteral("stationNotUnique"),
                        CommandLine::tr("The project has several devices at the station \"%1\": %2. Give the "
                                        "device number."),
                        {station, texts.join(QStringLiteral(", "))});
    if (places.front().isOnLine())
        return places.front();
    if (call.bus == nullptr)
        return badInput(
            QStringLiteral("stationOnBus"),
            CommandLine::tr("\"%1\" is a station on INTERBUS, and the link is a serial line. Give "
                            "the address of an encoder as two hexadecimal digits, as 05."),
            {station});
    if (!areSame(compareRings(structureOf(project), call.bus->structure())))
        return tl::unexpected(Complaint{
            ExitCode::refused,
            QStringLiteral("busDiffers"),
            sentence(CommandLine::tr("The bus differs from the project, so \"%1\" may stand elsewhere. See "
                                     "codewheel-cli compare, or give the device number."),
                     {station}),
            {station}});
    return places.front();
}

Checked<std::optional<Project>> projectNamed(const Arguments &arguments)
{
    const auto file = arguments.value("--project");
    if (!file)
        return std::nullopt;
    auto project = loadProject(*file);
    if (!project)
        return tl::unexpected(complaintAbout(project.error()));
    return *std::move(project);
}

Checked<void> saveUnlessChanged(const Project &project, const QString &file, const QByteArray &mark)
{
    if (const auto saved = saveProjectOver(mark, project, file); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    return {};
}

void useProject(const Call &call, const Project &project, const QString &file)
{
    if (call.line != nullptr && call.line->ledger() != nullptr) {
        call.line->ledger()->setProject(QFileInfo(file).absoluteFilePath());
        for (const ProjectDevice &device : devicesOn(project, firstLine))
            call.line->ledger()->setLabel(device.place(), device.label.serialNumber);
    }
    if (call.bus == nullptr)
        return;
    const RingStructure connected = call.bus->structure();
    const ProjectPlaces places(project, call.buses);
    for (const ProjectDevice &planned : devicesOn(project, call.bus->id())) {
        const auto found = std::ranges::find(connected, planned.place().node, &Participant::number);
        if (places.isAtItsPlace(planned.place()) && !planned.participant.deviceKey.isEmpty())
            nameDevice(call, planned, *found);
    }
    if (!areSame(compareRings(structureOf(project), connected)))
        call.terminal.complain(
            CommandLine::tr("The bus differs from the project. See codewheel-cli compare."));
    if (call.ledger == nullptr)
        return;
    call.ledger->setProject(QFileInfo(file).absoluteFilePath());
    for (const ProjectDevice &device : devicesOn(project, call.bus->id()))
        if (places.isAtItsPlace(device.place()))
            call.ledger->setLabel(device.place(), device.label.serialNumber);
}

Checked<QString> placeMeant(const Call &call, const QString &typed)
{
    if (call.project == nullptr)
        return typed;
    if (isOnLine(call, typed) && placesAt(*call.project, typed).empty())
        return typed;
    auto number = Place::parse(typed);
    if (!number || number->isOnLine()) {
        const auto station = placeOfStation(call, *call.project, typed);
        if (!station)
            return tl::unexpected(station.error());
        number = *station;
    }
    if (number->isOnLine())
        return number->toString();
    return checkSameDevice(call, *number).map([&] { return number->toString(); });
}

} // namespace codewheel
