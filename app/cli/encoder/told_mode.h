// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/arguments.h"
#include "cli/call/texts.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/refusal_text.h"

#include <QtGlobal>

namespace codewheel {

// For commands whose words would set a cam in cam mode.
inline constexpr Option inPositionModeOption{
    "--in-position-mode", nullptr,
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "say that the encoder is in position mode: in cam mode the same word sets a cam")};
// The user says so with that option. Only needed if the mode is not known; whether it was.
inline bool tellMode(EncoderSession &encoder, const Arguments &arguments)
{
    const bool isTold = arguments.has(inPositionModeOption.name) && !encoder.latest().mode;
    if (isTold)
        tellPositionMode(encoder);
    return isTold;
}

// With how to say so, where a mode that is not known was refused.
inline Complaint withHowToTellMode(Complaint complaint)
{
    if (complaint.key == refusalKey(RefusalId::modeNotKnown))
        complaint.text += u' ' + CommandLine::tr("Where you are sure of it, add --in-position-mode.");
    return complaint;
}

} // namespace codewheel
