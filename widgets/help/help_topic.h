// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace codewheel {

// What the manual says of a widget and all in it: a page of docs/manual, and mostly a heading of it, as the
// manual's own links have them: "parameters.md#write".
void setHelpTopic(QWidget &widget, const char *topic);

// That of the nearest ancestor that has one, across windows; empty: nobody has.
QString helpTopicOf(const QWidget *widget);

} // namespace codewheel
