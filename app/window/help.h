// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace codewheel {

// The keys of all actions of the window, and what they do.
void showKeys(QMainWindow &window);
// Version and licence.
void showAbout(QMainWindow &window);

} // namespace codewheel
