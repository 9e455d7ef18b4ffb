// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/word_reading.h"

#include "catalog/explain_word.h"
#include "catalog/total_range.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/position_code.h"
#include "kinds/interbus/words/profiles.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr std::array orderNames{"ABCD", "CDAB", "BADC", "DCBA"};

Register withBytesExchanged(Register word)
{
    return static_cast<Register>((word << 8) | (word >> 8));
}

bool exchangesBytes(WordOrder order)
{
    return order == WordOrder::badc || order == WordOrder::dcba;
}

bool isLowFirst(WordOrder order)
{
    return order == WordOrder::cdab || order == WordOrder::dcba;
}

Word wordIn(std::span<const Register> registers, WordOrder order)
{
    const auto its = [&](std::size_t i) -> Word {
        return exchangesBytes(order) ? withBytesExchanged(registers[i]) : registers[i];
    };
    if (registers.size() == 1)
        return its(0);
    return isLowFirst(order) ? (its(1) << 16) | its(0) : (its(0) << 16) | its(1);
}

Explanation explained(const DeviceDescription &device, Word word)
{
    return explainWord(device, word, {});
}

bool isNeverSent(const DeviceDescription &device, Word word)
{
    if (device.profile == profile::k3)
        return !k3::canSend(word, device.dialect.as<k3::Dialect>());
    const MeaningId meaning = explained(device, word).first().id;
    return meaning == MeaningId::undefinedIn || meaning == MeaningId::unusedBitsSet;
}

bool isWithin(std::int64_t position, std::int64_t totalRange, bool isSigned)
{
    if (isSigned)
        return position >= -(totalRange / 2) && position < (totalRange + 1) / 2;
    return position >= 0 && position < totalRange;
}

// As a position, in any coding it may have.
bool isBeyond(const Meaning &meaning, Word word, std::int64_t totalRange)
{
    const auto fits = [&](PositionCoding coding) {
        return isWithin(k3::decodePosition(word, coding), totalRange, coding == PositionCoding::signedBinary);
    };
    switch (meaning.id) {
    case MeaningId::position:
    case MeaningId::grayPosition:
        return !isWithin(meaning.number[0], totalRange, false);
    case MeaningId::signedPosition:
        return !isWithin(meaning.number[0], totalRange, true);
    case MeaningId::rawPosition:
        return !fits(PositionCoding::binary) && !fits(PositionCoding::signedBinary) &&
               !fits(PositionCoding::gray);
    default:
        return false;
    }
}

Plausibility judged(const SendingEncoder &sender, Word word)
{
    if (!sender.device)
        return Plausibility::notKnown;
    if (isNeverSent(*sender.device, word))
        return Plausibility::cannotBe;
    const Explanation meanings = explained(*sender.device, word);
    return sender.totalRange && isBeyond(meanings.first(), word, *sender.totalRange) ? Plausibility::unlikely
                                                                                     : Plausibility::fits;
}

} // namespace

QString wordOrderName(WordOrder order)
{
    return QString::fromLatin1(orderNames.at(static_cast<std::size_t>(order)));
}

WordOrder wordOrderOf(bool highWordFirst)
{
    return highWordFirst ? WordOrder::abcd : WordOrder::cdab;
}

SendingEncoder senderOf(const DeviceDescription &device, const ParameterValues &known)
{
    if (const auto range = totalRange(device, known))
        return {device, range};
    const std::int64_t physical = physicalRange(device);
    return {device, physical > 0 ? std::optional(physical) : std::nullopt};
}

std::vector<WordReading> wordReadings(std::span<const Register> registers, const SendingEncoder &sender)
{
    if (registers.empty())
        return {};
    const auto its = registers.first(std::min<std::size_t>(registers.size(), 2));
    std::vector<WordReading> readings;
    for (const WordOrder order : {WordOrder::abcd, WordOrder::cdab, WordOrder::badc, WordOrder::dcba}) {
        if (its.size() == 1 && isLowFirst(order))
            continue;
        const Word word = wordIn(its, order);
        readings.push_back(
            {order, word, judged(sender, word),
             sender.device ? explanationText(*sender.device, explained(*sender.device, word)) : QString()});
    }
    return readings;
}

const WordReading *readingIn(const std::vector<WordReading> &readings, WordOrder order)
{
    const auto found = std::ranges::find(readings, order, &WordReading::order);
    if (found != readings.end())
        return &*found;
    return readings.empty() ? nullptr : &readings.front();
}

} // namespace codewheel
