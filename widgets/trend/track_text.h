// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/mark.h"
#include "history/track.h"
#include "widgets/look/roles.h"

#include <QString>

namespace codewheel {

// What a track shows, in the user's language: "position", "IN", "OUT bit 25", "cam 1".
QString trackText(const Track &track);
QString unitName(TrackUnit unit); // "degrees"
// As it stands behind a number: "°", "rpm", "mm/s"; empty for words.
QString unitSymbol(const TrackScale &scale, Channel channel);

// What a mark says: the message with the place it concerns, or the note.
QString markText(const Mark &mark);
QColor markColor(const Mark &mark, const QPalette &palette);

} // namespace codewheel
