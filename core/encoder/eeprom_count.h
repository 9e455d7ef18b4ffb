// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

namespace codewheel {

// By what the writes of one encoder were told from those of others.
enum class CountedBy : std::uint8_t {
    session,           // nothing is kept: since the connection was made
    serialNumber,      // as the encoder told it
    labelSerialNumber, // typed from its label
    place,             // in its project; whatever encoder stood there
};

// How often this program has written to the EEPROM of an encoder. Never how often it was written at all.
struct EepromCount
{
    int writes = 0;
    // Begun, and the program ended before it saw whether they were carried out.
    int perhaps = 0;
    QDateTime since{}; // of the first one; null: there is none, or the time is not kept
    CountedBy by = CountedBy::session;
    QString serialNumber{}; // where it is counted by one

    int atMost() const { return writes + perhaps; }

    friend bool operator==(const EepromCount &, const EepromCount &) = default;
};

} // namespace codewheel
