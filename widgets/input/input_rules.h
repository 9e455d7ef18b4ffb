// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QObject;

namespace codewheel {

// What holds for keys, mouse and wheel in all windows of the program, as long as `parent` lives:
// No field changes by the wheel unless it has the focus, and the wheel gives no focus.
// Ctrl+Z in a field in which nothing is being typed undoes the last step of the project.
// A key that is held presses once.
// The second of two quick presses does not answer the question that the first one has opened.
void installInputRules(QObject *parent);

} // namespace codewheel
