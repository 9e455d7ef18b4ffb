// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

namespace codewheel {

class EscLineSession;

// What to do after an encoder was given a baud rate other than its line's: this connection goes on asking it
// at its own rate, but after reconnecting it would be silent. Shown by the settings of the line.
struct EscLineRate
{
    QString sentence;            // empty: nothing to do
    std::optional<int> baudRate; // shared by all encoders of the line, for the line to take

    friend bool operator==(const EscLineRate &, const EscLineRate &) = default;
};
EscLineRate lineRateAfter(const EscLineSession &line, Place changed, int baudRate);

} // namespace codewheel
