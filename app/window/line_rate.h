// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

namespace codewheel {

class LineSession;

// What is to be done after an encoder was given another baud rate than its line has: within the connection it
// is asked at its own, but connected again it would be silent. Shown by the settings of the line.
struct LineRate
{
    QString sentence;            // empty: nothing is to be done
    std::optional<int> baudRate; // of all encoders of the line, which the line should have too

    friend bool operator==(const LineRate &, const LineRate &) = default;
};
LineRate lineRateAfter(const LineSession &line, Place changed, int baudRate);

} // namespace codewheel
