// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

namespace codewheel {

// What distinguishes the writes of one encoder from those of others.
enum class CountedBy : std::uint8_t {
    session,           // nothing is kept: counted since the connection was made
    serialNumber,      // as reported by the encoder
    labelSerialNumber, // typed in from its label
    place,             // its place in the project, whatever encoder was there
};

// How often this program has written to the EEPROM of an encoder, never how often it was written in total.
struct EepromCount
{
    int writes = 0;
    // Started, but the program ended before it saw whether they were carried out.
    int perhaps = 0;
    QDateTime since{}; // of the first one; null: none yet, or the time is not kept
    CountedBy by = CountedBy::session;
    QString serialNumber{}; // if counted by serial number
    int atPlace = 0;        // counted by its place before, perhaps of this encoder

    int atMost() const { return writes + perhaps + atPlace; }

    friend bool operator==(const EepromCount &, const EepromCount &) = default;
};

} // namespace codewheel
