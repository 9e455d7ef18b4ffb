// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/state_text.h"

#include <QCoreApplication>

namespace codewheel {

QString waitingText()
{
    return QCoreApplication::translate(
        "EncoderState", "The encoder waits for its parameters or to be started, and gives no position.");
}

} // namespace codewheel
