// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

class QWidget;

namespace codewheel {

class TrainingWindow;

// The pictures of a ring behind a gateway: its connection with a test, its registers, its panel.
std::vector<Picture> gatewayPictures();
// A ring that is offered to others, with clients: as it is shown, without a socket.
std::vector<Picture> offerPictures();

// The pictures of the project: the plant with stations, groups and addresses in the structure editor; and
// beside the connected ring, from which it differs. Each returns the widget to show.
QWidget *structureEditorAtWork(TrainingWindow &shown);
QWidget *insertionAtWork(TrainingWindow &shown);
QWidget *comparisonAtWork(TrainingWindow &shown);
QWidget *offlineWindow(TrainingWindow &shown);
// Values of the project about to be written to encoders, and to a replacement encoder.
QWidget *transferAtWork(TrainingWindow &shown);
QWidget *replacementAtWork(TrainingWindow &shown);

} // namespace codewheel
