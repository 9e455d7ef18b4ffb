// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_command.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace codewheel::esc {

// What the bits of O, A and E mean (manual, "Warning Parameters", "Alarm Parameters", "Examples").
enum class BitId : std::uint8_t {
    counterClockwise,
    diagnosticActive,
    scalingOn,
    calculatedFactor,
    resolutionPerTurn, // 0: total measuring range
    limitSwitchActive,
    positionError,
    generalFault,
    batteryFlat,
    temperatureExceeded,
    frequencyExceeded,
    lightControl,
    batteryLimit,
    referenceReached,
    turningCounterClockwise,
    lowerLimitReached,
    upperLimitReached,
    positionWarning,
    standstill,
};

// One described bit of an answer, for views, JSON and the explanation.
struct BitRow
{
    int bit = 0; // 0..15
    BitId id = BitId::counterClockwise;
    const char *key = ""; // language-neutral: "batteryFlat"
};

// Lowest bit first; empty for commands whose answer has no bits.
std::span<const BitRow> bitsOf(Command command);

// In words, translated: what the bit means when it is 1, and when it is 0. Empty where 0 means nothing.
QString bitText(BitId id, bool isSet);

// The warnings of a device that sends the bytes in the other order, put right (the manual's example of E).
std::uint16_t swappedBytes(std::uint16_t warnings);

// What an answer to O, A or E says, highest bit first, as bitText(); a bit that is 1 and that no manual
// describes is given by its number. Empty if there is nothing to say.
QStringList bitTexts(Command command, std::uint16_t value);

} // namespace codewheel::esc
