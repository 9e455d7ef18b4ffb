// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// What is said of EncoderState::waiting, as a sentence.
QString waitingText();

} // namespace codewheel
