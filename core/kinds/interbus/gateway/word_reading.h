// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/gateway/register_port.h"
#include "vocabulary/word.h"

#include <optional>
#include <span>
#include <vector>

namespace codewheel {

// How the bytes A (most significant) to D of a word are in its registers, in the order in which the registers
// are: ABCD high word first, CDAB low word first. In the other two, which no setting gives, the gateway has
// exchanged the bytes of each register. A word of 16 bits has the first order and the third.
enum class WordOrder : std::uint8_t { abcd, cdab, badc, dcba };
QString wordOrderName(WordOrder order); // "ABCD"
WordOrder wordOrderOf(bool highWordFirst);

enum class Plausibility : std::uint8_t {
    fits,     // the encoder can have sent it
    unlikely, // beyond the total range that it is said to have
    cannotBe, // the encoder never sends it
    notKnown, // no description says what it sends
};

// A word as its registers give it in one order.
struct WordReading
{
    WordOrder order = WordOrder::abcd;
    Word word = 0;
    Plausibility plausibility = Plausibility::notKnown;
    QString meaning{}; // in the user's language; empty: not known

    friend bool operator==(const WordReading &, const WordReading &) = default;
};

// An encoder as far as its words can be judged.
struct SendingEncoder
{
    std::optional<DeviceDescription> device{}; // empty: none describes it
    std::optional<std::int64_t> totalRange{};  // positions; empty: not known
};

// With the values it is known to have; without them, with what its disc gives: no scaling has more.
SendingEncoder senderOf(const DeviceDescription &device, const ParameterValues &known);

// The IN word of an encoder in all orders there are for so many registers; more than two are left out.
std::vector<WordReading> wordReadings(std::span<const Register> registers, const SendingEncoder &sender);

// The one in this order; a word of 16 bits has the same with its low word first. Null: there is no word.
const WordReading *readingIn(const std::vector<WordReading> &readings, WordOrder order);

} // namespace codewheel
