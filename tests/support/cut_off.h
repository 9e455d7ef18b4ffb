// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

class QWidget;

namespace codewheel::test {

// Everything in sight in `part` of a window, itself and all it holds, that does not have the room it needs, a
// line each: a text that is clipped by its widget or by what the widget stands in; one that is elided and may
// not be (widgets/look/may_elide.h); one beyond its cell; an item that its box is too narrow for; tabs and
// tools that have no room beside the others; a widget that is smaller than it can be. What can be scrolled to
// is not cut off.
std::vector<QString> cutOff(QWidget &part);

} // namespace codewheel::test
