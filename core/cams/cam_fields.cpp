// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_fields.h"

#include "cams/cam_states.h"
#include "kinds/interbus/words/k3_word.h"

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

Word settingWord(CamField field, std::int64_t data)
{
    const auto bits = static_cast<Word>(data);
    switch (field.value) {
    case CamValue::start:
        return k3::setCamStart(field.cam, bits);
    case CamValue::stop:
        return k3::setCamStop(field.cam, bits);
    case CamValue::shift:
        return k3::setCamShift(bits);
    default:
        break;
    }
    return k3::setActiveCams(bits);
}

Word readOutWord(CamField field)
{
    switch (field.value) {
    case CamValue::start:
        return k3::readOutCams(k3::camStartCode + field.cam);
    case CamValue::stop:
        return k3::readOutCams(k3::camStopCode + field.cam);
    case CamValue::shift:
        return k3::readOutCams(k3::camShiftCode);
    default:
        break;
    }
    return k3::readOutCams(k3::camConfigurationCode);
}

std::optional<CamField> fieldSetBy(Word out)
{
    if (k3::isCamPosition(out))
        return CamField{k3::isCamStart(out) ? CamValue::start : CamValue::stop, k3::number(out)};
    if (k3::isCamConfiguration(out))
        return CamField{CamValue::activeCams};
    if (k3::isCamShift(out))
        return CamField{CamValue::shift};
    return std::nullopt;
}

std::optional<CamField> fieldReadBy(Word out)
{
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (readOutWord(camField(i)) == out)
            return camField(i);
    return std::nullopt;
}

std::int64_t dataOf(CamField field, Word out)
{
    switch (field.value) {
    case CamValue::activeCams:
        return out & 0xFFFF;
    case CamValue::shift:
        return out & 0xFF;
    default:
        return k3::data(out);
    }
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
