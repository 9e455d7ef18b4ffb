// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/appearance.h"

#include <QString>

namespace codewheel {

// How numbers are written: as the language does it, or with this sign before decimals.
enum class DecimalSign : std::uint8_t { ofLanguage, point, comma };

// What can be set of the program as a whole, beside what a project has.
struct ProgramSettings
{
    QString language{}; // "de", "en", or empty: the system's
    Appearance appearance{};
    DecimalSign decimalSign = DecimalSign::ofLanguage;
    int framesPerSecond = 30;
    int eepromQuestionFrom = 75;    // percent of what the manual speaks of; never more
    int largestMessageFile = 200;   // MB
    int traceRows = 20'000;         // of one encoder
    int secondsBetweenKeeping = 30; // of unsaved changes, for after a crash

    friend bool operator==(const ProgramSettings &, const ProgramSettings &) = default;
};

// What each may be; what is read from a file is brought into it.
struct SettingRange
{
    int least;
    int most;
};
inline constexpr SettingRange eepromQuestionRange{10, 75};
inline constexpr SettingRange messageFileRange{1, 10'000};
inline constexpr SettingRange traceRowsRange{1'000, 200'000};
inline constexpr SettingRange keepingRange{5, 600};
inline constexpr int frameRates[] = {10, 30, 60};

} // namespace codewheel
