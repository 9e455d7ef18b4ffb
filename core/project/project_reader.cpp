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

#include <limits>

namespace codewheel {
namespace {

using namespace project_keys;

constexpr int largestNumber = std::numeric_limits<int>::max();
constexpr int mostWords = ring_limit::points / 16; // of the whole ring in one direction

std::optional<int> address(const JsonObject &json, const char *key)
{
    const auto number = json.optionalNumber(key, 0, largestAddress);
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

} // namespace

Project ProjectReader::read(const Json::Value &root, FaultKeeper &faults)
{
    const JsonObject json(root, QString(),
                          {"format", "version", "title", "note", "link", "addresses", "cableKilometres",
                           "devices", "sequences", "serialLine"},
                          faults);
    Project project;
    project.title = json.freeText("title");
    project.note = json.freeText("note");
    if (json.has("link"))
        project.link = readLink(json.object("link", {"kind", "settings"}));
    if (json.has("addresses"))
        project.addresses = readAddresses(json.object("addresses", {"unit", "first", "step5"}));
    project.cableKilometres = json.decimalOr("cableKilometres", 0, 0, longestRemoteBus);
    ProjectReader reader;
    for (const JsonObject &row : json.array("devices",
                                            {"place", "level", "deviceCode", "inWords", "outWords", "device",
                                             "station", "group", "note", "label", "inAddress", "outAddress",
                                             "wanted", "stored", "wantedCams", "storedCams", "lastPosition"},
                                            ring_limit::devices))
        project.devices.push_back(reader.readDevice(row));
    if (json.has("sequences"))
        for (const JsonObject &row :
             json.array("sequences", {"name", "holdCycles", "words"}, mostProjectSequences))
            project.sequences.push_back({row.freeText("name"), readWordList(row)});
    if (json.has("serialLine"))
        project.line = readLine(
            json.object("serialLine", {"port", "adapter", "baudRate", "dataBits", "parity", "stopBits",
                                       "lowLatency", "pollInterval", "timeOut", "retries", "quietAfterWrite",
                                       "fractionBits", "topSpeed", "encoders"}));
    return project;
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

ProjectDevice ProjectReader::readDevice(const JsonObject &json)
{
    ProjectDevice device;
    device.participant = readParticipant(json);
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

Participant ProjectReader::readParticipant(const JsonObject &json)
{
    Participant participant;
    participant.number = readPlace(json);
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
NodeId ProjectReader::readPlace(const JsonObject &json)
{
    const QString told = json.text("place");
    const bool onLocalBus = told.contains(u'.') && !told.endsWith(QStringLiteral(".0"));
    const DeviceNumber place = nextNumber(m_lastPlace, onLocalBus);
    if (told != place.toString())
        json.report("place", tr("\"%1\" cannot stand here: by its place in the list this device is %2 on the "
                                "remote bus, or %3 on a local bus.")
                                 .arg(told, nextNumber(m_lastPlace, false).toString(),
                                      nextNumber(m_lastPlace, true).toString()));
    m_lastPlace = place;
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
