// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/event.h"

#include <QString>

#include <optional>

class QWidget;

namespace codewheel {

class EncoderSession;

// What the encoder has taken when a job is to be cancelled.
struct CancelSituation
{
    ParameterValues taken;   // by the encoder so far
    bool isActive = false;   // what it has taken is valid already: run was sent, and nothing since
    bool canRestore = false; // the values from before are known
    int writesToRestore = 0; // to the EEPROM, at most
    QString positionNote;    // what the position will read if it runs with what it has; may be empty
};

// Of a job whose last word is this progress.
CancelSituation situationOf(const EncoderSession &encoder, const Progress &progress);

// Cancel of a job after the encoder has taken something: restore the values from before, run with what it
// has, or leave it in parameterization. Before it has taken anything (Progress::hasTaken) there is nothing to
// ask: OnCancel::ifNothingTaken. Restoring writes to the EEPROM: where that has to be agreed to, it is
// asked for as well. Nothing: go on with the handshake. Also closes, with nothing, when the job ends
// meanwhile. Used by the wizard and by transfers.
std::optional<OnCancel> askHowToCancel(QWidget *parent, EncoderSession &encoder,
                                       const CancelSituation &situation);

} // namespace codewheel
