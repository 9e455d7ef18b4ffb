// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

class QWidget;

namespace codewheel {

class TrainingWindow;

// Recordings, played and compared.
std::vector<Picture> recordingPictures();
// The pictures of the trend.
std::vector<Picture> trendPictures();
// The wizard's pages with the example of FRABA's manual, and with a linear encoder.
std::vector<Picture> wizardPictures();
// A search for encoders that has found some: as it is shown, without a port.
std::vector<Picture> finderPictures();
// The first two sheets of the commissioning report, side by side. Returns the widget to show.
QWidget *reportOnPaper(TrainingWindow &shown);

} // namespace codewheel
