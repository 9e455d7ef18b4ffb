// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/kinds/training_window.h"

class QDockWidget;
class QWidget;

namespace codewheel::scene {

// Actions in a window for a picture, and their places.

inline constexpr Place fraba{firstBus, NodeId("1.0")};
inline constexpr Place baumer{firstBus, NodeId("2.0")};
inline constexpr Place rod{firstBus, NodeId("5.0")};
inline constexpr int whileMilliseconds = 600; // until a request is carried out

QDockWidget *dock(TrainingWindow &shown, const char *name);
void choose(TrainingWindow &shown, Place number);
// Presses the button of this name, if enabled, and waits for its effect.
void click(TrainingWindow &shown, const char *button);
// That with this text, if enabled.
void press(QWidget &view, const QString &text);
void start(TrainingWindow &shown, Place number, const Job &job, int milliseconds = whileMilliseconds);
void send(TrainingWindow &shown, Place number, Word word);
void readAll(TrainingWindow &shown, Place number = fraba);
// The example of the FRABA manual, 5.3, as wanted values of the first encoder.
void want255(TrainingWindow &shown);

} // namespace codewheel::scene
