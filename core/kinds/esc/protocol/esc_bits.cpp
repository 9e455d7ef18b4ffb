// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_bits.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/find_by.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel::esc {
namespace {

// Manual, "Examples: Read Operating Parameters", which numbers the bits across both bytes.
constexpr std::array operatingBits{
    BitRow{0, BitId::counterClockwise, "counterClockwise"},
    BitRow{1, BitId::diagnosticActive, "diagnosticActive"},
    BitRow{2, BitId::scalingOn, "scalingOn"},
    BitRow{12, BitId::calculatedFactor, "calculatedFactor"},
    BitRow{13, BitId::resolutionPerTurn, "resolutionPerTurn"},
    BitRow{14, BitId::limitSwitchActive, "limitSwitchActive"},
};

constexpr std::array alarmBits{
    BitRow{0, BitId::positionError, "positionError"},
    BitRow{12, BitId::generalFault, "generalFault"},
    BitRow{14, BitId::batteryFlat, "batteryFlat"},
    BitRow{15, BitId::temperatureExceeded, "temperatureExceeded"},
};

constexpr std::array warningBits{
    BitRow{0, BitId::frequencyExceeded, "frequencyExceeded"},
    BitRow{1, BitId::lightControl, "lightControl"},
    BitRow{4, BitId::batteryLimit, "batteryLimit"},
    BitRow{5, BitId::referenceReached, "referenceReached"},
    BitRow{11, BitId::turningCounterClockwise, "turningCounterClockwise"},
    BitRow{12, BitId::lowerLimitReached, "lowerLimitReached"},
    BitRow{13, BitId::upperLimitReached, "upperLimitReached"},
    BitRow{14, BitId::positionWarning, "positionWarning"},
    BitRow{15, BitId::standstill, "standstill"},
};

struct TextRow
{
    BitId id;
    const char *set;
    const char *clear; // empty: a 0 says nothing
};

constexpr std::array texts{
    TextRow{BitId::counterClockwise, QT_TRANSLATE_NOOP("EscBit", "direction CCW"),
            QT_TRANSLATE_NOOP("EscBit", "direction CW")},
    TextRow{BitId::diagnosticActive, QT_TRANSLATE_NOOP("EscBit", "diagnostic active"), ""},
    TextRow{BitId::scalingOn, QT_TRANSLATE_NOOP("EscBit", "scaling on"),
            QT_TRANSLATE_NOOP("EscBit", "scaling off")},
    TextRow{BitId::calculatedFactor, QT_TRANSLATE_NOOP("EscBit", "calculated factor"), ""},
    TextRow{BitId::resolutionPerTurn, QT_TRANSLATE_NOOP("EscBit", "resolution per revolution"),
            QT_TRANSLATE_NOOP("EscBit", "total measuring range")},
    TextRow{BitId::limitSwitchActive, QT_TRANSLATE_NOOP("EscBit", "limit switch active"), ""},
    TextRow{BitId::positionError, QT_TRANSLATE_NOOP("EscBit", "position error"), ""},
    TextRow{BitId::generalFault, QT_TRANSLATE_NOOP("EscBit", "general fault"), ""},
    TextRow{BitId::batteryFlat, QT_TRANSLATE_NOOP("EscBit", "battery flat"), ""},
    TextRow{BitId::temperatureExceeded, QT_TRANSLATE_NOOP("EscBit", "temperature exceeded"), ""},
    TextRow{BitId::frequencyExceeded, QT_TRANSLATE_NOOP("EscBit", "frequency exceeded"), ""},
    TextRow{BitId::lightControl, QT_TRANSLATE_NOOP("EscBit", "light control"), ""},
    TextRow{BitId::batteryLimit, QT_TRANSLATE_NOOP("EscBit", "battery limit reached"), ""},
    TextRow{BitId::referenceReached, QT_TRANSLATE_NOOP("EscBit", "reference point reached"), ""},
    TextRow{BitId::turningCounterClockwise, QT_TRANSLATE_NOOP("EscBit", "turning CCW"), ""},
    TextRow{BitId::lowerLimitReached, QT_TRANSLATE_NOOP("EscBit", "lower limit switch on"), ""},
    TextRow{BitId::upperLimitReached, QT_TRANSLATE_NOOP("EscBit", "upper limit switch on"), ""},
    TextRow{BitId::positionWarning, QT_TRANSLATE_NOOP("EscBit", "position warning"), ""},
    TextRow{BitId::standstill, QT_TRANSLATE_NOOP("EscBit", "standstill"), ""},
};

static_assert(areInOrder(texts, &TextRow::id) &&
              texts.size() == static_cast<std::size_t>(BitId::standstill) + 1);

constexpr int highestBit = 15;

} // namespace

std::span<const BitRow> bitsOf(Command command)
{
    if (command == Command::operatingParameters)
        return operatingBits;
    if (command == Command::alarms)
        return alarmBits;
    if (command == Command::warnings)
        return warningBits;
    return {};
}

QString bitText(BitId id, bool isSet)
{
    const TextRow &row = texts.at(static_cast<std::size_t>(id));
    return QCoreApplication::translate("EscBit", isSet ? row.set : row.clear);
}

std::uint16_t swappedBytes(std::uint16_t warnings)
{
    const unsigned bits = warnings;
    return static_cast<std::uint16_t>(bits << 8 | bits >> 8);
}

QStringList bitTexts(Command command, std::uint16_t value)
{
    const std::span<const BitRow> rows = bitsOf(command);
    QStringList said;
    for (int bit = highestBit; bit >= 0 && !rows.empty(); --bit) {
        const bool isSet = (static_cast<unsigned>(value) >> bit & 1U) != 0;
        if (const auto *row = findBy(rows, bit, &BitRow::bit))
            said << bitText(row->id, isSet);
        else if (isSet)
            said << QCoreApplication::translate("EscBit", "bit %1 (not described)").arg(bit);
    }
    said.removeAll(QString());
    return said;
}

} // namespace codewheel::esc
