// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/appearance.h"

#include <QString>

namespace codewheel {

// How numbers are written: in the style of the language, or with this decimal sign.
enum class DecimalSign : std::uint8_t { ofLanguage, point, comma };

// The settings of the program as a whole, apart from those of a project.
struct ProgramSettings
{
    QString language{}; // "de", "en", or empty: the system's
    Appearance appearance{};
    DecimalSign decimalSign = DecimalSign::ofLanguage;
    int framesPerSecond = 30;
    int eepromQuestionFrom = 75;    // percent of the manual's figure; never more
    QString userName{};             // entered with EEPROM writes; empty: none is given
    int largestMessageFile = 200;   // MB
    int traceRows = 20'000;         // of one encoder, or of the terminal of a line
    int trendMemory = 256;          // MB, for all encoders together
    int secondsBetweenKeeping = 30; // of unsaved changes, for recovery after a crash
    bool notifiesOfFaults = true;   // on the desktop, while no window of the program is in front
    bool notifiesWithSound = false;

    friend bool operator==(const ProgramSettings &, const ProgramSettings &) = default;
};

// The range of each setting; what is read from a file is brought into it.
struct SettingRange
{
    int least;
    int most;
};
inline constexpr SettingRange eepromQuestionRange{10, 75};
inline constexpr SettingRange messageFileRange{1, 10'000};
inline constexpr SettingRange traceRowsRange{1'000, 200'000};
inline constexpr SettingRange trendMemoryRange{16, 16'384};
inline constexpr SettingRange keepingRange{5, 600};
inline constexpr int frameRates[] = {10, 30, 60};

} // namespace codewheel
