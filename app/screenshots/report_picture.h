// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace codewheel {

class TrainingWindow;

// The first two sheets of the commissioning report, side by side. Returns the widget to show.
QWidget *reportOnPaper(TrainingWindow &shown);

} // namespace codewheel
