// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_program_json.h"
#include "cams/check_cams.h"
#include "project/project_keys.h"
#include "project/project_reader.h"

#include <algorithm>
#include <set>

namespace codewheel {
namespace {

using namespace project_keys;

// Parameters of one list, each only once.
class ParameterReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ProjectReader)

public:
    Parameter read(const JsonObject &json)
    {
        const QString key = json.text("parameter");
        const auto parameter = parameterFromKey(key);
        if (!parameter)
            json.report("parameter", tr("There is no parameter \"%1\".").arg(key));
        else if (!m_seen.insert(*parameter).second)
            json.report("parameter", tr("The parameter \"%1\" is already given above.").arg(key));
        return parameter.value_or(Parameter::steps);
    }

private:
    std::set<Parameter> m_seen;
};

Evidence readEvidence(const JsonObject &json)
{
    return json.oneOf("evidence", evidences);
}

} // namespace

ParameterValues ProjectReader::readValues(const JsonObject &json, const char *key)
{
    ParameterValues values;
    ParameterReader parameters;
    if (json.has(key))
        for (const JsonObject &row : json.array(key, {"parameter", "value"}, allParameters().size()))
            values.push_back({parameters.read(row), row.value("value")});
    std::ranges::sort(values, {}, &ParameterValue::parameter);
    return values;
}

std::vector<StoredValue> ProjectReader::readStored(const JsonObject &json)
{
    std::vector<StoredValue> values;
    ParameterReader parameters;
    if (json.has("stored"))
        for (const JsonObject &row :
             json.array("stored", {"parameter", "value", "evidence", "at"}, allParameters().size()))
            values.push_back({parameters.read(row), row.value("value"), readEvidence(row), readTime(row)});
    std::ranges::sort(values, {}, &StoredValue::parameter);
    return values;
}

std::vector<CamProgram> ProjectReader::readWantedCams(const JsonObject &json)
{
    std::vector<CamProgram> cams;
    CamProgramReader programs(largestCamPosition);
    if (json.has("wantedCams"))
        for (const JsonObject &row :
             json.array("wantedCams", {"program", "shift", "cams"}, CamProgram::programs))
            cams.push_back(programs.read(row));
    std::ranges::sort(cams, {}, &CamProgram::number);
    return cams;
}

std::vector<StoredCams> ProjectReader::readStoredCams(const JsonObject &json)
{
    std::vector<StoredCams> cams;
    CamProgramReader programs(largestCamPosition);
    if (json.has("storedCams"))
        for (const JsonObject &row :
             json.array("storedCams", {"program", "shift", "cams", "evidence", "at"}, CamProgram::programs))
            cams.push_back({programs.read(row), readEvidence(row), readTime(row)});
    std::ranges::sort(cams, {}, [](const StoredCams &stored) { return stored.program.number; });
    return cams;
}

} // namespace codewheel
