// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

class QWidget;

namespace codewheel {

// Asks before a job that has no review of its own, once the EEPROM has been written as often as the manual
// mentions, and wants the place typed beyond what it guarantees. True, without a question, if there is
// nothing to ask.
bool askForEeprom(QWidget *window, EncoderSession &encoder, const Job &job);
// Before a word sent by hand, and before a cancelled job restores the previous values.
bool askForEeprom(QWidget *window, EncoderSession &encoder, int planned);

} // namespace codewheel
