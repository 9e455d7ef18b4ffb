// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace codewheel {

// What a screen reader tells of a widget and of all that is in it and visible: a line each, indented, with
// role, name, value, description and states.
QString accessibleTree(QWidget &widget);

} // namespace codewheel
