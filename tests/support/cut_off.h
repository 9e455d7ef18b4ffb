// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

class QWidget;

namespace codewheel::test {

// Everything visible in `part` of a window, itself and all its children, that lacks the room it needs, a line
// each: a text clipped by its widget or an ancestor; one that is elided and may not be
// (widgets/look/may_elide.h); one outside its cell; an item too wide for its box; tabs and tools without room
// beside the others; a widget smaller than its minimum. What can be scrolled to is not cut off.
std::vector<QString> cutOff(QWidget &part);

} // namespace codewheel::test
