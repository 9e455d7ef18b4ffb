// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace codewheel {

class TrainingWindow;

// What the pictures of the project show: the plant with stations, groups and addresses in the structure
// editor; and beside the connected ring, from which it differs. Each answers what is to be seen.
QWidget *structureEditorAtWork(TrainingWindow &shown);
QWidget *insertionAtWork(TrainingWindow &shown);
QWidget *comparisonAtWork(TrainingWindow &shown);
QWidget *offlineWindow(TrainingWindow &shown);
// Values of the project on their way to the encoders, and to an encoder that was put in place of another.
QWidget *transferAtWork(TrainingWindow &shown);
QWidget *replacementAtWork(TrainingWindow &shown);

} // namespace codewheel
