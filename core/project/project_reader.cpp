// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "project/project_reader.h"

#include "project/process_addresses.h"
#include "project/project_json.h"
#include "project/project_keys.h"
#include "project/word_list_json.h"
#include "ring/cycle_time.h"
#include "ring/numbering.h"
#include "ring/ring_rules.h"

#include <algorithm>
#include <limits>

namespace codewheel {
namespace {

using namespace project_keys;

constexpr int largestNumber = std::numeric_limits<int>::max();
constexpr std::size_t mostBuses = 100;
constexpr int mostWords = ring_limit::points / 16; // of the whole ring in one direction

std::optional<int> address(const JsonObject &json, const char *key)
{
    const auto number = json.optionalNumber(key, 0, largestAddress);
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

} // namespace

Project ProjectReader::read(const Json::Value &root, FaultKeeper &faults)
{
    const JsonObject json(root, QString(), {"format", "version", "title", "note", "buses", "sequences"},
                          faults);
    Project project;
    project.buses.clear();
    project.title = json.freeText("title");
    project.note = json.freeText("note");
    for (const JsonObject &row : json.arrayOfAny("buses", mostBuses))
        readBus(row, project);
    std::ranges::stable_sort(project.buses, {}, &PlannedBus::id);
    std::ranges::stable_sort(project.devices, {}, &ProjectDevice::bus);
    if (json.has("sequences"))
        for (const JsonObject &row :
             json.array("sequences", {"name", "holdCycles", "words"}, mostProjectSequences))
            project.sequences.push_back({row.freeText("name"), readWordList(row)});
    return project;
}

void ProjectReader::readBus(const JsonObject &json, Project &project)
{
    PlannedBus bus;
    bus.kind = json.text("kind");
    bus.id = {static_cast<int>(json.number("number", 1, largestNumber))};
    bus.name = json.text("name");
    if (findBus(project, bus.id) != nullptr)
        json.report("number", tr("Another bus above has the number %1.").arg(bus.id.number));
    if (std::ranges::find(project.buses, bus.name, &PlannedBus::name) != project.buses.end())
        json.report("name", tr("Another bus above is called \"%1\".").arg(bus.name));
    std::vector<ProjectDevice> devices;
    if (bus.kind == QLatin1String(interbusKind))
        bus.settings = KindData(readRing(json, devices));
    else if (bus.kind == QLatin1String(escKind))
        bus.settings = KindData(readLine(json, devices));
    else
        json.reportUnknownName("kind", bus.kind, {QLatin1String(interbusKind), QLatin1String(escKind)});
    for (ProjectDevice &device : devices) {
        device.bus = bus.id;
        project.devices.push_back(std::move(device));
    }
    project.buses.push_back(std::move(bus));
}

RingPlan ProjectReader::readRing(const JsonObject &json, std::vector<ProjectDevice> &devices)
{
    json.allowOnly({"kind", "number", "name", "link", "addresses", "cableKilometres", "devices"});
    RingPlan plan;
    if (json.has("link"))
        plan.link = readLink(json.object("link", {"kind", "settings"}));
    if (json.has("addresses"))
        plan.addresses = readAddresses(json.object("addresses", {"unit", "first", "step5"}));
    plan.cableKilometres = json.decimalOr("cableKilometres", 0, 0, longestRemoteBus);
    DeviceNumber last;
    for (const JsonObject &row : json.array("devices",
                                            {"place", "level", "deviceCode", "inWords", "outWords", "device",
                                             "station", "group", "note", "label", "inAddress", "outAddress",
                                             "wanted", "stored", "wantedCams", "storedCams", "lastPosition"},
                                            ring_limit::devices)) {
        devices.push_back(readDevice(row, last));
        last = devices.back().participant.deviceNumber();
    }
    return plan;
}

ProjectLink ProjectReader::readLink(const JsonObject &json)
{
    return {json.text("kind"), json.textsByKey("settings")};
}

AddressRules ProjectReader::readAddresses(const JsonObject &json)
{
    AddressRules rules;
    if (json.has("unit"))
        rules.unit = json.oneOf("unit", units);
    rules.first = json.numberOr("first", 0, 0, largestAddress);
    rules.step5 = json.flagOr("step5", false);
    return rules;
}

ProjectDevice ProjectReader::readDevice(const JsonObject &json, DeviceNumber before)
{
    ProjectDevice device;
    device.participant = readParticipant(json, before);
    device.inAddress = address(json, "inAddress");
    device.outAddress = address(json, "outAddress");
    device.wantedCams = readWantedCams(json);
    device.storedCams = readStoredCams(json);
    readWhatIsKnown(json, device);
    return device;
}

// What an encoder of a ring and one of a serial line have in common.
void ProjectReader::readWhatIsKnown(const JsonObject &json, ProjectDevice &device)
{
    device.station = json.freeText("station");
    device.group = json.freeText("group");
    device.note = json.freeText("note");
    if (json.has("label"))
        device.label = readLabel(json.object("label", {"turns", "stepsPerTurn", "serialNumber"}));
    device.wanted = readWanted(json);
    device.stored = readStored(json);
    if (json.has("lastPosition"))
        device.lastPosition = readLastPosition(json.object("lastPosition", {"position", "at"}));
}

Participant ProjectReader::readParticipant(const JsonObject &json, DeviceNumber before)
{
    Participant participant;
    participant.number = readPlace(json, before);
    participant.level = json.numberOr("level", 0, 0, ring_limit::levels - 1);
    participant.deviceCode = json.hexNumber("deviceCode");
    if (participant.deviceCode > 0xFFFF)
        json.report("deviceCode", tr("A device code has at most four digits, such as \"0237h\"."));
    participant.idCode = participant.deviceCode & 0xFF;
    participant.inWords = static_cast<int>(json.number("inWords", 0, mostWords));
    participant.outWords = static_cast<int>(json.number("outWords", 0, mostWords));
    participant.deviceKey = json.freeText("device");
    return participant;
}

// The number follows from the place in the list; that it is told as well makes the file readable.
NodeId ProjectReader::readPlace(const JsonObject &json, DeviceNumber before)
{
    const QString told = json.text("place");
    const bool onLocalBus = told.contains(u'.') && !told.endsWith(QStringLiteral(".0"));
    const DeviceNumber place = nextNumber(before, onLocalBus);
    if (told != place.toString())
        json.report("place", tr("\"%1\" cannot stand here: by its place in the list this device is %2 on the "
                                "remote bus, or %3 on a local bus.")
                                 .arg(told, nextNumber(before, false).toString(),
                                      nextNumber(before, true).toString()));
    return place.node();
}

DeviceLabel ProjectReader::readLabel(const JsonObject &json)
{
    return {json.numberOr("turns", 0, 0, largestNumber), json.numberOr("stepsPerTurn", 0, 0, largestNumber),
            json.freeText("serialNumber")};
}

// Without its time nobody can tell whether the shaft still stands there.
LastPosition ProjectReader::readLastPosition(const JsonObject &json)
{
    LastPosition last{json.number("position"), readTime(json)};
    if (!json.has("at"))
        json.report("at", tr("A time such as \"2026-03-01T14:02:00.000Z\" is expected here (UTC)."));
    return last;
}

QDateTime ProjectReader::readTime(const JsonObject &json)
{
    const QString text = json.freeText("at");
    QDateTime at = QDateTime::fromString(text, Qt::ISODateWithMs);
    if (at.isValid() != json.has("at") || (at.isValid() && at.toUTC().toString(Qt::ISODateWithMs) != text))
        json.report("at", tr("A time such as \"2026-03-01T14:02:00.000Z\" is expected here (UTC)."));
    return at;
}

} // namespace codewheel
