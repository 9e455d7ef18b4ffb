// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// What is said of EncoderState::waiting, as a sentence.
inline QString waitingText()
{
    return QCoreApplication::translate(
        "EncoderState", "The encoder waits for its parameters or to be started, and gives no position.");
}

} // namespace codewheel
