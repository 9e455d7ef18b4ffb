// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

class QWidget;

namespace codewheel {

enum class ModeAnswer { isInPositionMode, switchFirst, cancel };

// The mode is not known, and in cam mode `out` would set a cam.
ModeAnswer askForMode(QWidget *window, const EncoderSession &encoder, Word out);

// Says what it does and what it costs; true: do it.
bool askToLeaveCamMode(QWidget *window, const EncoderSession &encoder);
bool askForFrabaPreset(QWidget *window, EncoderSession &encoder);
bool askForReset(QWidget *window, const EncoderSession &encoder);
// To one that was left in parameterization or in an error. `positionThen`: as for whatFollowsRun().
bool askToSendRun(QWidget *window, const EncoderSession &encoder, const QString &positionThen = {});
// Run, then these values again.
bool askToRestore(QWidget *window, const EncoderSession &encoder, const ParameterValues &values);

} // namespace codewheel
