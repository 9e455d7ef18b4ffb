// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace codewheel {

// The manual's topic for a widget and everything in it: a page of docs/manual, usually with a heading, in the
// form of the manual's own links: "parameters.md#write".
void setHelpTopic(QWidget &widget, const char *topic);

// The topic of the nearest ancestor that has one, across windows; empty: none has.
QString helpTopicOf(const QWidget *widget);

} // namespace codewheel
