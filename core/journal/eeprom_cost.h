// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

namespace codewheel {

// How often a job writes to the encoder's EEPROM at most; 0: not at all. What is found to be there already,
// or is refused, costs less (docs/protocols/k3.md, "EEPROM").
int mostEepromWrites(const EncoderSession &encoder, const Job &job);
// 0 or 1: a word that goes out by hand.
int mostEepromWrites(const EncoderSession &encoder, Word word);
// What a running job costs beside that, if it is cancelled and the values from before are written again.
int mostWritesToRestore(const Progress &progress);

// What has to be said or asked before so many writes are added to those there were, by what the manual of the
// encoder states.
enum class EepromConcern : std::uint8_t {
    none,     // also where the manual is silent
    question, // from three quarters of the budget on, or earlier if so set, each write is asked for
    typed,    // the manual guarantees nothing any more: the place has to be typed
};
// From this share of the budget on, in percent; the usual is 75, and more is taken as that. For the whole
// program.
void askFromEepromShare(int percent);
EepromConcern eepromConcern(int writesSoFar, int planned, const Capabilities &can);
EepromConcern eepromConcern(const EncoderSession &encoder, int planned);

// "12 writes by this program since 1 Mar 2026, by serial number 4711."
QString eepromCountText(const EepromCount &count);
// With the serial number as its encoder shows it: of a Kübler 8 hexadecimal digits.
QString eepromCountText(const EncoderSession &encoder);
// "12 writes from here since 1 Mar 2026": where there is little room.
QString eepromCountBrief(const EepromCount &count);
// What is said at a concern; empty: none. `planned` is what is added.
QString eepromConcernText(const EncoderSession &encoder, int planned);

} // namespace codewheel
