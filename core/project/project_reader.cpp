// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "project/project_reader.h"

#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/project_json.h"
#include "project/project_keys.h"
#include "project/word_list_json.h"

#include <algorithm>
#include <limits>

namespace codewheel {
namespace {

using namespace project_keys;

constexpr int largestNumber = std::numeric_limits<int>::max();

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
    bus.name = json.freeText("name");
    if (bus.name.trimmed().isEmpty())
        json.report("name", tr("A bus needs a name, such as \"Ring\"."));
    if (findBus(project, bus.id) != nullptr)
        json.report("number", tr("Another bus above has the number %1.").arg(bus.id.number));
    if (std::ranges::find(project.buses, bus.name, &PlannedBus::name) != project.buses.end())
        json.report("name", tr("Another bus above is called \"%1\".").arg(bus.name));
    if (bus.name.contains(u'/'))
        json.report("name",
                    tr("The name of a bus has no \"/\", which separates it from the place of a device."));
    std::vector<ProjectDevice> devices;
    if (const BusKind *kind = busKind(bus.kind))
        bus.settings = kind->read(json, devices);
    else
        json.reportUnknownName("kind", bus.kind, busKindKeys());
    for (ProjectDevice &device : devices) {
        device.bus = bus.id;
        project.devices.push_back(std::move(device));
    }
    project.buses.push_back(std::move(bus));
}

void ProjectReader::readWhatIsKnown(const JsonObject &json, ProjectDevice &device)
{
    device.station = json.freeText("station");
    device.group = json.freeText("group");
    device.note = json.freeText("note");
    if (json.has("label"))
        device.label = readLabel(json.object("label", {"turns", "stepsPerTurn", "serialNumber"}));
    device.wanted = readValues(json, "wanted");
    device.stored = readStored(json);
    if (json.has("lastPosition"))
        device.lastPosition = readLastPosition(json.object("lastPosition", {"position", "at", "scale"}));
}

DeviceLabel ProjectReader::readLabel(const JsonObject &json)
{
    return {json.numberOr("turns", 0, 0, largestNumber), json.numberOr("stepsPerTurn", 0, 0, largestNumber),
            json.freeText("serialNumber")};
}

// Without its time nobody can tell whether the shaft is still there.
LastPosition ProjectReader::readLastPosition(const JsonObject &json)
{
    LastPosition last{json.number("position"), readTime(json), readValues(json, "scale")};
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
