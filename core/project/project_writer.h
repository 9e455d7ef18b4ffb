// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_writer.h"
#include "project/project.h"

namespace codewheel {

// Writes a project file part by part, in the order of docs/project-files.md. One object per file; used by
// projectToJson().
class ProjectWriter
{
public:
    QByteArray write(const Project &project);

    // For the kinds of bus: the file, and what all their devices have in common.
    JsonWriter &json() { return m_json; }
    void writeText(const char *key, const QString &text);
    void writeNumber(const char *key, std::optional<std::int64_t> number);
    void writeNames(const ProjectDevice &device);
    void writeValues(const ProjectDevice &device);
    void writeCams(const ProjectDevice &device);
    void writeLastPosition(const ProjectDevice &device);

private:
    void writeBus(const Project &project, const PlannedBus &bus);
    void writeValues(const char *key, const ParameterValues &values);
    void writeLabel(const DeviceLabel &label);
    void writeEvidence(Evidence evidence, const QDateTime &at);

    JsonWriter m_json;
};

} // namespace codewheel
