// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_explain_parts.h"

namespace codewheel::k3 {

Meaning camParameter(Word word) noexcept
{
    if (isCamConfiguration(word))
        return {MeaningId::camConfiguration, {word & 0xFFFF}};
    if (isCamShift(word))
        return {MeaningId::setCamShift, {word & 0xFF}};
    return {isCamStart(word) ? MeaningId::camStart : MeaningId::camStop, {number(word), data(word)}};
}

Meaning camReadOutRequest(Word word) noexcept
{
    const Word code = word & 0xFFFF;
    const Word cam = code & 0xF;
    if (code == camConfigurationCode)
        return {MeaningId::camConfigurationRequest};
    if (code == camShiftCode || code == camShiftCodeOfTable)
        return {MeaningId::camShiftRequest};
    if (cam < camCount && code - cam == camStartCode)
        return {MeaningId::camStartRequest, {cam}};
    if (cam < camCount && code - cam == camStopCode)
        return {MeaningId::camStopRequest, {cam}};
    return {MeaningId::undefinedOut, {word}};
}

Meaning camReadOutValue(Word request, Word value) noexcept
{
    const Meaning asked = camReadOutRequest(request);
    switch (asked.id) {
    case MeaningId::camConfigurationRequest:
        return {MeaningId::camConfigurationValue, {value}};
    case MeaningId::camShiftRequest:
        return {MeaningId::camShiftValue, {value}};
    case MeaningId::camStartRequest:
        return {MeaningId::camStartValue, {asked.number[0], value}};
    case MeaningId::camStopRequest:
        return {MeaningId::camStopValue, {asked.number[0], value}};
    default:
        return {MeaningId::selfTestOrReadOut, {value}};
    }
}

Explanation camConfirmations(Word in, std::optional<Word> out) noexcept
{
    if (out && isCamParameter(*out) && (*out | confirmation) == in)
        return Meaning{MeaningId::camConfirmation, {*out}};
    Explanation possible;
    const Word withoutD30 = in & ~confirmation;
    for (const Word candidate : {withoutD30, withoutD30 | presetBit})
        if (isCamParameter(candidate))
            possible.add({MeaningId::camConfirmation, {candidate}});
    return possible;
}

} // namespace codewheel::k3
