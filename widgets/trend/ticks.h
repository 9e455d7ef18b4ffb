// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/rough_duration.h"
#include "history/sample.h"

#include <QString>

#include <vector>

namespace codewheel {

// Where an axis has its labels, and what they are.
struct Tick
{
    double at = 0; // 0..1 of the axis
    QString text;
};

// Round numbers: multiples of 1, 2 or 5 times a power of ten, at most `most` of them.
double tickStep(double range, int most);
std::vector<Tick> valueTicks(double low, double high, int most, const QLocale &locale);
// Of 32-bit words: multiples of a power of 16, as eight digits.
std::vector<Tick> hexTicks(double low, double high, int most);
double hexStep(double range, int most);
// Round times of the local day, as precise as their distance; the day itself where it begins.
std::vector<Tick> timeTicks(const TimeSpan &span, int most, const QLocale &locale);

// Time and, where asked for, the day, as precise as one of a thousand parts of `length`.
QString timeText(Instant at, Instant length, const QLocale &locale);
QString dayText(Instant at, const QLocale &locale);
QString spanDayText(const TimeSpan &span, const QLocale &locale); // its day, or its days
// "+1.250 s", "35.2 min": with the unit that suits its size.
QString durationText(Instant duration, const QLocale &locale);
// With as many decimals as tell values `resolution` apart.
QString valueText(double value, double resolution, const QLocale &locale);

} // namespace codewheel
