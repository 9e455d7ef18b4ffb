// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_fields.h"

#include "kinds/interbus/words/k3_cam_word.h"

namespace codewheel {

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

} // namespace codewheel
