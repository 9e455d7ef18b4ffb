// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>

#include <functional>
#include <initializer_list>

class QWidget;

namespace codewheel {

// Does `then` at each of these events of the widget: when its font, style or palette has changed, say, or it
// was shown or resized. Its own handler is still to come. Called at the end of its constructor, since they
// may come at any time from then on.
void onEvent(QWidget *widget, std::initializer_list<QEvent::Type> events, std::function<void()> then);
// Of another one, as long as the receiver is there.
void onEventOf(QObject *watched, std::initializer_list<QEvent::Type> events, QObject *receiver,
               std::function<void()> then);

} // namespace codewheel
