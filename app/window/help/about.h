// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace codewheel {

// Version and licence.
void showAbout(QMainWindow &window);

} // namespace codewheel
