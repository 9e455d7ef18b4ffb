// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"
#include "project/project.h"

namespace codewheel {

// The rules of a project file of the newest version, part by part. One object per file; errors are reported
// to the JsonObject's keeper, and reading goes on with harmless values.
class ProjectReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ProjectReader)

public:
    static Project read(const Json::Value &root, FaultKeeper &faults);

    // What devices of all kinds of bus have in common.
    static void readWhatIsKnown(const JsonObject &json, ProjectDevice &device);
    static std::vector<CamProgram> readWantedCams(const JsonObject &json);
    static std::vector<StoredCams> readStoredCams(const JsonObject &json);

private:
    static void readBus(const JsonObject &json, Project &project);
    static DeviceLabel readLabel(const JsonObject &json);
    static ParameterValues readValues(const JsonObject &json, const char *key);
    static std::vector<StoredValue> readStored(const JsonObject &json);
    static LastPosition readLastPosition(const JsonObject &json);
    static QDateTime readTime(const JsonObject &json);
};

} // namespace codewheel
