// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;
class QDir;

namespace codewheel {

// Every view of the window at work, as PNG files, light ("window.png") and dark ("window-dark.png"). False if
// a file cannot be written.
bool makeManualPictures(QApplication &application, const QDir &folder);

// The same views, each in the whole window in its three sizes ("1024x640/window.png"), to be looked through.
bool makeReviewPictures(QApplication &application, const QDir &folder);

} // namespace codewheel
