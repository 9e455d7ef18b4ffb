// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_fields.h"

#include "cams/cam_states.h"

namespace codewheel {

std::size_t indexOf(CamField field)
{
    switch (field.value) {
    case CamValue::start:
        return std::size_t{2} * field.cam;
    case CamValue::stop:
        return std::size_t{2} * field.cam + 1;
    case CamValue::activeCams:
        break;
    case CamValue::shift:
        return camFieldCount - 1;
    case CamValue::hysteresis:
        return camFieldCount + field.cam;
    case CamValue::invertedCams:
        return allCamFieldCount - 1;
    }
    return camFieldCount - 2;
}

std::int64_t valueOf(const CamProgram &program, CamField field)
{
    switch (field.value) {
    case CamValue::start:
        return program.cam[field.cam].start;
    case CamValue::stop:
        return program.cam[field.cam].stop;
    case CamValue::activeCams:
        break;
    case CamValue::shift:
        return program.shift;
    case CamValue::hysteresis:
        return program.cam[field.cam].hysteresis;
    case CamValue::invertedCams:
        return invertedCams(program);
    }
    return activeCams(program);
}

void setValue(CamProgram &program, CamField field, std::int64_t data)
{
    switch (field.value) {
    case CamValue::start:
        program.cam[field.cam].start = data;
        return;
    case CamValue::stop:
        program.cam[field.cam].stop = data;
        return;
    case CamValue::activeCams:
        for (std::size_t n = 0; n < CamProgram::cams; ++n)
            program.cam[n].active = (data >> n & 1) != 0;
        return;
    case CamValue::shift:
        program.shift = static_cast<unsigned>(data);
        return;
    case CamValue::hysteresis:
        program.cam[field.cam].hysteresis = data;
        return;
    case CamValue::invertedCams:
        for (std::size_t n = 0; n < CamProgram::cams; ++n)
            program.cam[n].isInverted = (data >> n & 1) != 0;
        return;
    }
}

CamFieldSet differences(const CamProgram &a, const CamProgram &b)
{
    CamFieldSet different;
    for (std::size_t i = 0; i < camFieldCount; ++i)
        different[i] = valueOf(a, camField(i)) != valueOf(b, camField(i));
    return different;
}

} // namespace codewheel
