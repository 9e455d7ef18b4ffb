// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_writer.h"
#include "project/line_plan.h"
#include "project/ring_plan.h"

namespace codewheel {

// Writes a project file part by part, in the order of docs/project-files.md. One object a file; used by
// projectToJson().
class ProjectWriter
{
public:
    QByteArray write(const Project &project);

private:
    void writeBus(const Project &project, const PlannedBus &bus);
    void writeRing(const RingPlan &plan, std::span<const ProjectDevice> devices);
    void writeText(const char *key, const QString &text);
    void writeNumber(const char *key, std::optional<std::int64_t> number);
    void writeLink(const ProjectLink &link);
    void writeAddresses(const AddressRules &rules);
    void writeDevice(const ProjectDevice &device);
    void writeNames(const ProjectDevice &device);
    void writeLastPosition(const ProjectDevice &device);
    void writeParticipant(const Participant &participant);
    void writeLabel(const DeviceLabel &label);
    void writeValues(const ProjectDevice &device);
    void writeCams(const ProjectDevice &device);
    void writeEvidence(Evidence evidence, const QDateTime &at);

    // project_writer_line.cpp
    void writeLine(const LinePlan &line, std::span<const ProjectDevice> encoders);
    void writeAdapter(const LineAdapter &adapter);

    JsonWriter m_json;
};

} // namespace codewheel
