// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

class QWidget;

namespace codewheel {

// Asks before a job that has no review of its own, where the EEPROM was written as often as the manual speaks
// of, and lets the place be typed beyond what it guarantees. True, without a question, where nothing is to be
// asked.
bool askForEeprom(QWidget *window, EncoderSession &encoder, const Job &job);
// Before a word that goes out by hand, and before a cancelled job writes the values from before again.
bool askForEeprom(QWidget *window, EncoderSession &encoder, int planned);

} // namespace codewheel
