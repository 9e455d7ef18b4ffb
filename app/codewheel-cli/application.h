// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <memory>

namespace codewheel {

// The Qt application the program needs. For a PDF it has fonts, but neither looks for a screen nor needs one.
// argc and argv must outlive it.
std::unique_ptr<QCoreApplication> makeApplication(int &argc, char **argv);

} // namespace codewheel
