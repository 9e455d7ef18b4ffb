// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

namespace codewheel {

// How often a job writes to the encoder's EEPROM at most; 0: not at all. What turns out to be there already,
// or is refused, costs less (docs/protocols/k3.md, "EEPROM").
int mostEepromWrites(const EncoderSession &encoder, const Job &job);
// 0 or 1: for a word sent by hand.
int mostEepromWrites(const EncoderSession &encoder, Word word);
// What a running job costs in addition if it is cancelled and the previous values are written again.
int mostWritesToRestore(const EncoderSession &encoder, const Progress &progress);

// What has to be said or asked before this many writes are added to the existing ones, according to the
// manual of the encoder.
enum class EepromConcern : std::uint8_t {
    none,     // also if the manual is silent
    question, // from three quarters of the budget on, or earlier if so set: each write is confirmed
    typed,    // the manual no longer guarantees anything: the place has to be typed
};
// From this share of the budget on, in percent; 75 by default, which is also the maximum. For the whole
// program.
void askFromEepromShare(int percent);
EepromConcern eepromConcern(int writesSoFar, int planned, const Capabilities &can);
EepromConcern eepromConcern(const EncoderSession &encoder, int planned);

// "3", "3, perhaps 1 more": of a job, or in all.
QString eepromWritesText(int writes, int perhaps);
// "12 writes by this program since 1 Mar 2026, by serial number 4711."
QString eepromCountText(const EepromCount &count);
// With the serial number as its encoder shows it: for a Kübler 8 hexadecimal digits.
QString eepromCountText(const EncoderSession &encoder);
// "12 writes by Codewheel since 1 Mar 2026, S/N?": where there is little room. What was
// counted by a serial number that has not been read again is not in the count of a place.
QString eepromCountBrief(const EepromCount &count);
// The text for a concern; empty: none. `planned` is what is added.
QString eepromConcernText(const EncoderSession &encoder, int planned);

} // namespace codewheel
