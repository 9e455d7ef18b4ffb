// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"
#include "vocabulary/cam_program.h"

#include <set>

namespace codewheel {

class JsonWriter;

// Cam programs as cam files and projects hold them: objects with the keys "program", "shift" and "cams". Used
// for one list of them, in which each number may occur once.
class CamProgramReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CamFileReader)

public:
    // No start or stop may be above `largestPosition`.
    explicit CamProgramReader(std::int64_t largestPosition)
        : m_largestPosition(largestPosition)
    {}

    CamProgram read(const JsonObject &json);

private:
    void readCam(const JsonObject &json, CamProgram &program, unsigned &seen) const;

    std::int64_t m_largestPosition;
    std::set<unsigned> m_seen;
};

// All eight cams, in ascending order.
void writeCamProgram(JsonWriter &json, const CamProgram &program);

} // namespace codewheel
