// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/training_window.h"

class QDockWidget;

namespace codewheel::scene {

// What is done in a window for a picture, and where.

inline constexpr DeviceNumber fraba{1, 0};
inline constexpr DeviceNumber baumer{2, 0};
inline constexpr DeviceNumber rod{5, 0};
inline constexpr int whileMilliseconds = 600; // until what was asked for is done

QDockWidget *dock(TrainingWindow &shown, const char *name);
void choose(TrainingWindow &shown, DeviceNumber number);
// Presses the button of this name, if it can be pressed, and waits for what it does.
void click(TrainingWindow &shown, const char *button);
void start(TrainingWindow &shown, DeviceNumber number, const Job &job, int milliseconds = whileMilliseconds);
void send(TrainingWindow &shown, DeviceNumber number, Word word);
void readAll(TrainingWindow &shown, DeviceNumber number = fraba);
// The example of the FRABA manual, 5.3, as wanted values of the first encoder.
void want255(TrainingWindow &shown);

} // namespace codewheel::scene
