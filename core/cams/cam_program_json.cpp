// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_program_json.h"

#include "catalog/json_writer.h"

namespace codewheel {

CamProgram CamProgramReader::read(const JsonObject &json)
{
    CamProgram program;
    program.number = static_cast<unsigned>(json.number("program", 1, CamProgram::programs));
    program.shift = static_cast<unsigned>(json.number("shift", 0, CamProgram::largestShift));
    unsigned seen = 0;
    for (const JsonObject &row :
         json.array("cams", {"cam", "start", "stop", "active", "hysteresis", "inverted"}, CamProgram::cams))
        readCam(row, program, seen);
    if (!m_seen.insert(program.number).second)
        json.report("program", tr("Cam program %1 is already given above.").arg(program.number));
    return program;
}

void CamProgramReader::readCam(const JsonObject &json, CamProgram &program, unsigned &seen) const
{
    const auto number = static_cast<std::size_t>(json.number("cam", 0, CamProgram::cams - 1));
    const unsigned bit = 1U << number;
    if ((seen & bit) != 0)
        json.report("cam", tr("Cam %1 is already given above.").arg(number));
    seen |= bit;
    Cam &cam = program.cam[number];
    cam.start = json.number("start", 0, m_largestPosition);
    cam.stop = json.number("stop", 0, m_largestPosition);
    cam.active = json.flag("active");
    cam.hysteresis = json.optionalNumber("hysteresis", 0, m_largestPosition).value_or(0);
    cam.isInverted = json.flagOr("inverted", false);
}

void writeCamProgram(JsonWriter &json, const CamProgram &program)
{
    json.member("program", program.number);
    json.member("shift", program.shift);
    std::size_t number = 0;
    json.lines("cams", program.cam, [&](const Cam &cam) {
        json.member("cam", number++);
        json.member("start", cam.start);
        json.member("stop", cam.stop);
        json.flag("active", cam.active);
        if (cam.hysteresis > 0)
            json.member("hysteresis", cam.hysteresis);
        if (cam.isInverted)
            json.flag("inverted", true);
    });
}

} // namespace codewheel
