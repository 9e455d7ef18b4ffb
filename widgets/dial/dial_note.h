// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"

#include <QRect>

class QFontMetrics;
class QPainter;
class QWidget;

// The sentence below a dial, with its icon: what is wrong or missing. Shared by the dials, disc and rod.
namespace codewheel::dial_note {

// Lines the note takes, never fewer than two, so that the dial does not move when a note appears.
int lines(const QFontMetrics &metrics, int width, const QString &note);
void paint(QPainter &painter, const QWidget &dial, const QRect &space, Role role, const QString &note);

} // namespace codewheel::dial_note
