// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/la66_explain.h"

// LA-66 manual 2.2, 2.3, 3.
namespace codewheel::la66 {
namespace {

Meaning explainOut(Word word) noexcept
{
    const std::int64_t bit = isServiceMode(word) ? 1 : 0;
    if (isService(word) && !isWrite(word))
        return {MeaningId::serviceRead, {service(word), bit}};
    if (isService(word))
        return {accepts(service(word), data(word)) ? MeaningId::serviceWrite : MeaningId::serviceWriteInvalid,
                {service(word), data(word), bit}};
    if (word == normalMode)
        return {MeaningId::normalRunning};
    if ((word & ~dataMask) == 0)
        return {MeaningId::normalRunningData, {word}};
    return {MeaningId::undefinedOut, {word}};
}

// D31 = 0: D30 and D28..D24 are 0.
Meaning normal(Word word) noexcept
{
    if ((word & ~(errorBit | dataMask)) != 0)
        return {MeaningId::undefinedIn, {word}};
    return {hasError(word) ? MeaningId::positionWithError : MeaningId::position, {data(word)}};
}

// D31 = 1
Meaning answer(Word word, std::optional<Word> out) noexcept
{
    if (hasError(word)) // IN = OUT with D29 = 1 (assumed)
        return {MeaningId::serviceRefused, {word & ~errorBit}};
    if (!isService(word))
        return {MeaningId::undefinedIn, {word}};
    if (out && isServiceMode(*out) && !answers(word, *out))
        return {MeaningId::oldServiceAnswer, {service(word), data(word), service(*out)}};
    return {isWrite(word) ? MeaningId::serviceWritten : MeaningId::serviceValue, {service(word), data(word)}};
}

} // namespace

Explanation explain(Word word, WordDirection direction, std::optional<Word> counterpart) noexcept
{
    if (direction == WordDirection::out)
        return explainOut(word);
    return isServiceMode(word) ? answer(word, counterpart) : normal(word);
}

} // namespace codewheel::la66
