// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/arguments.h"

#include <QtGlobal>

#include <span>

namespace codewheel {

// Options of more than one service.
inline constexpr Option lostOption{
    "--lost", "N",
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "of 1000 bytes (esc) or frames (canopen), so many are lost")};
inline constexpr Option doubledOption{
    "--doubled", "N",
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "of 1000 bytes or frames, so many come twice")};
inline constexpr Option delayedOption{
    "--delayed", "N",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "of 1000 bytes or frames, so many come later, with all that follow them")};
inline constexpr Option delayOption{"--delay", "MS",
                                    QT_TRANSLATE_NOOP("codewheel::CommandLine", "how much later (20)")};
inline constexpr Option silentOption{
    "--silent", "ADDRESS",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "an encoder that does not answer; several as 03,12; all for all of them")};
inline constexpr Option seedOption{
    "--seed", "N", QT_TRANSLATE_NOOP("codewheel::CommandLine", "another run of the same faults (1)")};

inline constexpr int mostOfThousand = 1'000;
inline constexpr int longestServedDelay = 10'000; // ms
inline constexpr int usualServedDelay = 20;       // ms
inline constexpr int largestSeed = 1'000'000'000;

// An option of a service that takes a number, and where it goes.
struct ServedNumber
{
    const char *option;
    int otherwise;
    int minimum;
    int maximum;
    int &value;
};

// The first wrong one is reported.
inline Checked<void> takeNumbers(const Arguments &arguments, std::span<const ServedNumber> rows)
{
    for (const ServedNumber &row : rows) {
        const auto number = arguments.number(row.option, row.otherwise, row.minimum, row.maximum);
        if (!number)
            return tl::unexpected(number.error());
        row.value = *number;
    }
    return {};
}

} // namespace codewheel
