// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"
#include "project/line_plan.h"
#include "project/ring_plan.h"

namespace codewheel {

// The rules of a project file of the newest version, part by part. One object a file; what is wrong is
// reported to the JsonObject's keeper, and reading goes on with harmless values.
class ProjectReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ProjectReader)

public:
    static Project read(const Json::Value &root, FaultKeeper &faults);

private:
    static void readBus(const JsonObject &json, Project &project);
    static RingPlan readRing(const JsonObject &json, std::vector<ProjectDevice> &devices);
    static ProjectLink readLink(const JsonObject &json);
    static AddressRules readAddresses(const JsonObject &json);
    static ProjectDevice readDevice(const JsonObject &json, DeviceNumber before);
    static void readWhatIsKnown(const JsonObject &json, ProjectDevice &device);
    static Participant readParticipant(const JsonObject &json, DeviceNumber before);
    static NodeId readPlace(const JsonObject &json, DeviceNumber before);
    static DeviceLabel readLabel(const JsonObject &json);
    static ParameterValues readWanted(const JsonObject &json);
    static std::vector<StoredValue> readStored(const JsonObject &json);
    static std::vector<CamProgram> readWantedCams(const JsonObject &json);
    static std::vector<StoredCams> readStoredCams(const JsonObject &json);
    static LastPosition readLastPosition(const JsonObject &json);
    static QDateTime readTime(const JsonObject &json);

    // project_reader_line.cpp
    static LinePlan readLine(const JsonObject &json, std::vector<ProjectDevice> &encoders);
    static void readEncoders(const JsonObject &json, std::vector<ProjectDevice> &encoders);
    static LineAdapter readAdapter(const JsonObject &json);
};

} // namespace codewheel
