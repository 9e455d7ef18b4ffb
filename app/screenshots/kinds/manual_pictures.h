// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

class QApplication;
class QDir;

namespace codewheel {

// Every view of the window in use. The window has already been shown for a moment.
std::vector<Picture> manualPictures();
constexpr int beforePicture = 99; // ms

// All of them as PNG files, light ("window.png") and dark ("window-dark.png"). False: a file could not be
// written.
bool makeManualPictures(QApplication &application, const QDir &folder);

// The same views, each in the whole window in its three sizes ("1024x640/window.png"), for review.
bool makeReviewPictures(QApplication &application, const QDir &folder);

// The same views as a screen reader tells them, each in a text file ("window.txt").
bool makeAccessibleTrees(const QDir &folder);

} // namespace codewheel
