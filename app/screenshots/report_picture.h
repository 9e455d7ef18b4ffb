// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace codewheel {

class TrainingWindow;

// The first two sheets of the commissioning report, side by side. Answers what is to be seen.
QWidget *reportOnPaper(TrainingWindow &shown);

} // namespace codewheel
