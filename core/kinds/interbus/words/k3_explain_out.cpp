// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_explain_parts.h"

// OUT: FRABA manual 5.2, 10.1, 10.2, 10.5; Baumer manual 2.2.
namespace codewheel::k3 {
namespace {

constexpr Word resetWord = parameterWord(setToDefault, 0);

Meaning undefined(Word word) noexcept
{
    return {MeaningId::undefinedOut, {word}};
}

// D31..D29 = 000
Meaning parameterOrNothing(Word word, const ExplainContext &context) noexcept
{
    if (word == normalRunning)
        return {MeaningId::normalRunning};
    if (!isParameterWord(word))
        return {MeaningId::normalRunningData, {data(word)}};
    if (!mayBeOutsideCamMode(context))
        return {MeaningId::parameterRequestInCamMode, {number(word), data(word)}};
    if (word == resetWord)
        return {MeaningId::resetToDefault};
    return {MeaningId::parameterRequest, {number(word), data(word)}};
}

// A word that means one thing in cam mode and another, or nothing, outside it.
Explanation byMode(Word word, std::optional<MeaningId> outsideCamMode, const ExplainContext &context) noexcept
{
    Explanation possible;
    if (outsideCamMode && mayBeOutsideCamMode(context))
        possible.add({*outsideCamMode});
    if (isCamParameter(word) && mayBeIn(Mode::cam, context))
        possible.add(camParameter(word));
    if (possible.size() == 0)
        possible.add(undefined(word));
    return possible;
}

// 2021xxxx
Meaning readOutRequest(Word word) noexcept
{
    constexpr Word opcRegisterCode = 0xD;
    const Word code = word & 0xFFFF;
    if (code <= 0xFF && (code & 0xF) == opcRegisterCode)
        return {MeaningId::opcRegisterRequest, {code >> 4}};
    return {MeaningId::readOutRequest, {code}};
}

std::optional<MeaningId> frabaCommand(Word word) noexcept
{
    switch (word) {
    case initialisePreset:
        return MeaningId::initialisePreset;
    case frabaPreset:
        return MeaningId::frabaPreset;
    case velocityOn:
        return MeaningId::velocityOn;
    case velocityOff:
        return MeaningId::velocityOff;
    default:
        return std::nullopt;
    }
}

// D31 = 0 and D30 or D29 = 1
Explanation explainFraba(Word word, const ExplainContext &context) noexcept
{
    if (isReadOutRequest(word))
        return readOutRequest(word);
    if (isCamReadOutRequest(word))
        return camReadOutRequest(word);
    if (word == programWord)
        return Meaning{MeaningId::positionMode};
    if (isProgramWord(word))
        return Meaning{MeaningId::camMode, {word & 0xF}};
    return byMode(word, frabaCommand(word), context);
}

// D31 = 0 and D30 or D29 = 1, make not known: it may be FRABA, the only one with modes other than position.
// What is being read out depends on the make.
Explanation explainGeneric(Word word, const ExplainContext &context) noexcept
{
    if (isReadOutRequest(word))
        return Meaning{MeaningId::manufacturerSpecificOut, {word}};
    const Explanation ofFraba = explainFraba(word, context);
    const bool isOfFraba = ofFraba.first().id != MeaningId::undefinedOut;
    const bool isFraba = context.mode.value_or(Mode::position) != Mode::position;
    if ((word & manufacturerBit) == 0 || (isOfFraba && isFraba))
        return ofFraba;
    Explanation possible(Meaning{MeaningId::manufacturerSpecificOut, {word}});
    if (isOfFraba)
        for (const Meaning &meaning : ofFraba)
            possible.add(meaning);
    return possible;
}

// D31 = 0 and D30 or D29 = 1
Explanation explainBaumer(Word word) noexcept
{
    if (word & manufacturerBit)
        return Meaning{MeaningId::manufacturerBitIgnored, {word & ~manufacturerBit}};
    return word == initialisePreset ? Meaning{MeaningId::initialisePreset} : undefined(word);
}

} // namespace

Explanation explainOut(Word word, const ExplainContext &context) noexcept
{
    if (word == run)
        return Meaning{MeaningId::run};
    if (word & startBit)
        return Meaning{MeaningId::runIgnoresRest, {word & ~startBit}};
    if ((word & statusMask) == 0)
        return parameterOrNothing(word, context);
    switch (context.dialect) {
    case Dialect::fraba:
        return explainFraba(word, context);
    case Dialect::baumer:
        return explainBaumer(word);
    case Dialect::generic:
        break;
    }
    return explainGeneric(word, context);
}

} // namespace codewheel::k3
