// SPDX-License-Identifier: GPL-3.0-or-later
// docs/project-files.md
#include "project/project_writer.h"

#include "cams/cam_program_json.h"
#include "catalog/hex_code.h"
#include "project/bus_kind.h"
#include "project/project_json.h"
#include "project/project_keys.h"
#include "project/word_list_json.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace project_keys;

template <typename Rows, typename Key>
Rows sorted(Rows rows, Key key)
{
    std::ranges::stable_sort(rows, {}, key);
    return rows;
}

} // namespace

QByteArray ProjectWriter::write(const Project &project)
{
    m_json.member("format", formatName);
    m_json.member("version", projectMigrations().size() + 1);
    writeText("title", project.title);
    writeText("note", project.note);
    m_json.list("buses", project.buses, [&](const PlannedBus &bus) { writeBus(project, bus); });
    m_json.list("sequences", project.sequences, [&](const ProjectSequence &sequence) {
        writeText("name", sequence.name);
        writeWordList(m_json, sequence.list);
    });
    return m_json.finish();
}

void ProjectWriter::writeBus(const Project &project, const PlannedBus &bus)
{
    m_json.member("kind", bus.kind);
    m_json.member("number", bus.id.number);
    m_json.member("name", bus.name);
    if (const BusKind *kind = busKind(bus.kind))
        kind->write(*this, bus.settings, devicesOn(project, bus.id));
}

// A missing text takes no line.
void ProjectWriter::writeText(const char *key, const QString &text)
{
    if (!text.isEmpty())
        m_json.member(key, text);
}

void ProjectWriter::writeNumber(const char *key, std::optional<std::int64_t> number)
{
    if (number)
        m_json.member(key, *number);
}

void ProjectWriter::writeNames(const ProjectDevice &device)
{
    writeText("station", device.station);
    writeText("group", device.group);
    writeText("note", device.note);
    writeLabel(device.label);
}

void ProjectWriter::writeLastPosition(const ProjectDevice &device)
{
    if (device.lastPosition)
        m_json.object("lastPosition", [&] {
            m_json.member("position", device.lastPosition->position);
            m_json.member("at", device.lastPosition->at.toUTC().toString(Qt::ISODateWithMs));
            writeValues("scale", device.lastPosition->scale);
        });
}

void ProjectWriter::writeLabel(const DeviceLabel &label)
{
    if (label == DeviceLabel())
        return;
    m_json.object("label", [&] {
        if (label.turns != 0)
            m_json.member("turns", label.turns);
        if (label.stepsPerTurn != 0)
            m_json.member("stepsPerTurn", label.stepsPerTurn);
        writeText("serialNumber", label.serialNumber);
    });
}

void ProjectWriter::writeValues(const char *key, const ParameterValues &values)
{
    if (!values.empty())
        m_json.lines(key, sorted(values, &ParameterValue::parameter), [&](const ParameterValue &value) {
            m_json.member("parameter", parameterKey(value.parameter));
            m_json.value("value", value.value);
        });
}

void ProjectWriter::writeValues(const ProjectDevice &device)
{
    writeValues("wanted", device.wanted);
    if (!device.stored.empty())
        m_json.lines("stored", sorted(device.stored, &StoredValue::parameter), [&](const StoredValue &value) {
            m_json.member("parameter", parameterKey(value.parameter));
            m_json.value("value", value.value);
            writeEvidence(value.evidence, value.at);
        });
}

void ProjectWriter::writeCams(const ProjectDevice &device)
{
    if (!device.wantedCams.empty())
        m_json.list("wantedCams", sorted(device.wantedCams, &CamProgram::number),
                    [&](const CamProgram &program) { writeCamProgram(m_json, program); });
    if (!device.storedCams.empty())
        m_json.list("storedCams",
                    sorted(device.storedCams, [](const StoredCams &cams) { return cams.program.number; }),
                    [&](const StoredCams &cams) {
                        writeEvidence(cams.evidence, cams.at);
                        writeCamProgram(m_json, cams.program);
                    });
}

void ProjectWriter::writeEvidence(Evidence evidence, const QDateTime &at)
{
    m_json.member("evidence", nameOf(evidences, evidence));
    if (at.isValid())
        m_json.member("at", at.toUTC().toString(Qt::ISODateWithMs));
}

QByteArray projectToJson(const Project &project)
{
    return ProjectWriter().write(project);
}

} // namespace codewheel
