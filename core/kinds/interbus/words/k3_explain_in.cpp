// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_explain_parts.h"
#include "kinds/interbus/words/position_code.h"

// IN: FRABA manual 5.2, 5.3, 10.3, 10.4, 10.6; Baumer manual 2.3, 7.
namespace codewheel::k3 {
namespace {

constexpr unsigned unknownNumberError = 2;       // in cam mode: wrong command
constexpr unsigned manufacturerErrorNumber = 12; // 980000xx
constexpr unsigned readOutUnknownNumber = 2;     // A4......

Meaning position(Word word, std::optional<PositionCoding> coding) noexcept
{
    if (!coding)
        return {MeaningId::rawPosition, {data(word)}};
    const std::int64_t steps = decodePosition(word, *coding);
    switch (*coding) {
    case PositionCoding::signedBinary:
        return {MeaningId::signedPosition, {steps}};
    case PositionCoding::gray:
        return {MeaningId::grayPosition, {steps, data(word)}};
    case PositionCoding::binary:
        break;
    }
    return {MeaningId::position, {steps}};
}

// D31 D30 = 00. D29..D25 mean nothing here.
Explanation operation(Word word, const ExplainContext &context) noexcept
{
    Explanation possible;
    if (mayBeIn(Mode::position, context))
        possible.add(position(word, context.coding));
    if (mayBeIn(Mode::velocity, context))
        possible.add({MeaningId::velocity, {signedData(word)}});
    if (mayBeIn(Mode::cam, context))
        possible.add({MeaningId::cams, {word & 0xFF, data(word) >> 8}});
    return possible;
}

// The parameter OUT asks for, if it asks for one.
std::optional<Word> parameterAskedFor(const ExplainContext &context) noexcept
{
    if (!context.counterpart)
        return std::nullopt;
    const Word ignored = context.dialect == Dialect::baumer ? manufacturerBit : 0;
    const Word out = *context.counterpart & ~ignored;
    return isParameterWord(out) ? std::optional(out) : std::nullopt;
}

Meaning parameterConfirmation(Word word, const ExplainContext &context) noexcept
{
    if (number(word) == 0)
        return {MeaningId::processing, {data(word)}};
    const auto asked = parameterAskedFor(context);
    if (!asked || number(*asked) == number(word))
        return {MeaningId::confirmed, {number(word), data(word)}};
    // A Baumer that is processing shows the new data beside the previous number.
    if (context.dialect == Dialect::baumer && data(*asked) == data(word))
        return {MeaningId::processing, {data(word)}};
    return {MeaningId::oldConfirmation, {number(word), data(word), number(*asked)}};
}

// D31 D30 = 11. Cam mode has no parameter words, and the other modes no cam words: OUT may reveal the mode.
Explanation parameterization(Word word, const ExplainContext &context) noexcept
{
    const bool askedForParameter = parameterAskedFor(context).has_value();
    const bool askedForCam = context.counterpart && isCamParameter(*context.counterpart) &&
                             (*context.counterpart | confirmation) == word;
    Explanation possible;
    if (mayBeOutsideCamMode(context) && !(askedForCam && mayBeIn(Mode::cam, context)))
        possible.add(parameterConfirmation(word, context));
    if (mayBeIn(Mode::cam, context) && !(askedForParameter && mayBeOutsideCamMode(context)))
        for (const Meaning &meaning : camConfirmations(word, context.counterpart))
            possible.add(meaning);
    if (possible.size() == 0)
        possible.add({MeaningId::undefinedIn, {word}});
    return possible;
}

// D31 D30 D29 = 101 with FRABA: the answer does not say what it answers.
Meaning readOutAnswerOf(Word word, const ExplainContext &context) noexcept
{
    if (number(word) == readOutUnknownNumber)
        return {MeaningId::readOutUnknown, {data(word)}};
    if (number(word) != 0)
        return {MeaningId::undefinedIn, {word}};
    if (!context.counterpart)
        return {MeaningId::selfTestOrReadOut, {data(word)}};
    const Word out = *context.counterpart;
    if (isCamReadOutRequest(out))
        return camReadOutValue(out, data(word));
    const Explanation asked = explainOut(out, {WordDirection::out, Dialect::fraba, {}, {}, {}});
    if (asked.first().id == MeaningId::readOutRequest)
        return {MeaningId::readOutValue, {asked.first().number[0], data(word)}};
    if (asked.first().id == MeaningId::opcRegisterRequest)
        return {MeaningId::opcRegisterValue, {asked.first().number[0], data(word)}};
    return {MeaningId::selfTestOrReadOut, {data(word)}};
}

// D31 D30 D29 = 100
Explanation errorOf(Word word, const ExplainContext &context) noexcept
{
    const bool fraba = context.dialect == Dialect::fraba;
    const unsigned error = number(word);
    if (error == 0)
        return Meaning{MeaningId::noValidPosition};
    if (fraba && error == manufacturerErrorNumber && data(word) <= 0xFF)
        return Meaning{MeaningId::manufacturerError, {data(word)}};
    Explanation possible;
    if (error != unknownNumberError || mayBeOutsideCamMode(context))
        possible.add({MeaningId::deviceError, {error, data(word)}});
    if (error == unknownNumberError && mayBeIn(Mode::cam, context))
        possible.add({MeaningId::wrongCamCommand, {data(word)}});
    return possible;
}

} // namespace

Explanation explainIn(Word word, const ExplainContext &context) noexcept
{
    if (isOperation(word))
        return operation(word, context);
    if (isConfirmation(word))
        return parameterization(word, context);
    if (!isErrorOrReadOut(word))
        return Meaning{MeaningId::unknownState, {word}};
    if (isReadOutAnswer(word) && context.dialect == Dialect::fraba)
        return readOutAnswerOf(word, context);
    if (isReadOutAnswer(word) && context.dialect == Dialect::generic)
        return Meaning{MeaningId::manufacturerSpecificIn, {word}};
    return errorOf(word, context);
}

} // namespace codewheel::k3
